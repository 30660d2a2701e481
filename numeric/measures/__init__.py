"""What is measured on a curve: boxes, length, curvature, inflections, the nearest point."""
