"""Where curves meet: crossings, touching points, and the arcs they share."""
