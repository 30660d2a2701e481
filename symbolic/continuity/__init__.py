"""Joints of two segments: conditions for C^k and G^k, and the verdict on two given segments."""
