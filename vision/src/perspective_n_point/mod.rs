//! Where a camera is that sees known points.
