//! Curves through motions, motions fitted to points, and means of motions.

mod curves;
mod fit;
mod mean;
mod smooth;
