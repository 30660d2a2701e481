/**
 * Light or dark, as the host page is: JupyterLab and Sphinx themes say so in an attribute, other
 * pages leave it to the system's preference. Colours are CSS variables, so that nothing is redrawn.
 */

function hostTheme(/** @type {MediaQueryList} */ prefersDark) {
  const lab = document.body.dataset.jpThemeLight;
  if (lab) return lab === "true" ? "light" : "dark";
  const { theme } = document.documentElement.dataset;
  if (theme === "light" || theme === "dark") return theme;
  return prefersDark.matches ? "dark" : "light";
}

/** So many control points get a colour by their index; the palette's come round again and again. */
const COLOURS = 36;

/** @param {import("./scene.js").Palette} palette */
function paint(/** @type {HTMLElement} */ root, palette) {
  const { points } = palette;
  for (let i = 0; i < COLOURS; i++) root.style.setProperty(`--point-${i}`, points[i % points.length]);
  for (const role of /** @type {const} */ (["curve", "construction", "muted", "accent"])) {
    root.style.setProperty(`--${role}`, palette[role]);
  }
}

/** @param {import("./scene.js").Colour | undefined} colour */
export function cssColour(colour) {
  return typeof colour === "number" ? `var(--point-${colour % COLOURS})` : `var(--${colour ?? "curve"})`;
}

/**
 * Give `root` the host's theme and keep following it.
 * @param {HTMLElement} root
 * @param {{light: import("./scene.js").Palette, dark: import("./scene.js").Palette} | undefined} palette
 * @param {import("./life.js").Life} life
 */
export function followTheme(root, palette, life) {
  const prefersDark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    const theme = hostTheme(prefersDark);
    root.dataset.theme = theme;
    if (palette) paint(root, palette[theme]);
  };
  apply();
  life.listen(prefersDark, "change", apply);
  const observer = new MutationObserver(life.guarded(apply));
  observer.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  observer.observe(document.body, { attributeFilter: ["data-jp-theme-light"] });
  life.onEnd(() => observer.disconnect());
}
