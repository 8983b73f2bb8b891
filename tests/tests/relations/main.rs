//! Relations of two elements of cga3: angles, distances, incidence, meets, joins and projections.

mod angle;
mod circle_angles;
mod distance;
mod dual_forms;
mod edges;
mod incidence;
mod join;
mod meet;
mod meet_degenerate;
mod projected;
mod projection;
mod ray;
mod ray_degenerate;
mod sizes;
mod tangent;
