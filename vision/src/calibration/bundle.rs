//! The bundle adjustment of the cameras of a rig, with all boards.

use ga_runtime::cga3::{Direction, Motor, MotorGenerator, Point};
use ga_runtime::vga3::Vector;

use super::board_view::{BoardView, SeenPoint};
use super::lens_terms::parameter_name;
use ga_camera::{FrameProjection, Intrinsics, by_twist};
use ga_numerics::least_squares::{Columns, Equations, Problem};

/// The unknowns of a twist: the angular velocity and the velocity of the origin.
pub(super) const TWIST: usize = 6;

/// The corners of boards as one camera or more see them.
///
/// What is made least is the sum of the squared distances, in pixels, between corners and the
/// projections of their places on the boards. The motor of each board takes it into the first
/// camera's frame; those of the other cameras take the first camera's frame into theirs. Motors
/// vary by twists on the left: `M' = exp(G) M` moves a point x of the frame with `ω × x + u`.
pub(super) struct Bundle<'a> {
    /// The places of all points on the board.
    pub(super) places: &'a [Point<f64>],
    /// For each camera and each board the points that it sees, none where it does not see it.
    pub(super) views: Vec<Vec<&'a BoardView>>,
    /// For each camera, which intrinsic parameters vary.
    pub(super) free: Vec<Vec<usize>>,
}

/// The unknowns of a bundle.
#[derive(Clone, Debug)]
pub(super) struct BundleState {
    pub(super) cameras: Vec<Intrinsics>,
    /// From the first camera's frame into those of the others.
    pub(super) motions: Vec<Motor<f64>>,
    pub(super) boards: Vec<Motor<f64>>,
}

impl Bundle<'_> {
    /// The first column of a camera's parameters.
    pub(super) fn first_column(&self, camera: usize) -> usize {
        self.free[..camera].iter().map(Vec::len).sum()
    }

    /// The first column of the twist of a camera's motion, which the first one has not.
    pub(super) fn motion_column(&self, camera: usize) -> usize {
        self.first_column(self.free.len()) + TWIST * (camera - 1)
    }

    fn shared(&self) -> usize {
        self.motion_column(self.free.len())
    }

    /// How many points a camera sees on each board.
    pub(super) fn counts(&self, camera: usize) -> impl Iterator<Item = usize> {
        self.views[camera].iter().map(|view| view.points().len())
    }

    /// The name of the unknown of a column.
    pub(super) fn unknown_name(&self, state: &BundleState, column: usize) -> &'static str {
        for (camera, free) in self.free.iter().enumerate() {
            let place = column.checked_sub(self.first_column(camera));
            if let Some(parameter) = place.and_then(|place| free.get(place)) {
                return parameter_name(&state.cameras[camera], *parameter);
            }
        }
        match column < self.shared() {
            true => "the motion between the cameras",
            false => "the motion of a board",
        }
    }

    /// The squared distances between corners and projections, summed for each camera and board;
    /// infinite for a board of which the camera cannot see a corner.
    pub(super) fn squared_errors(&self, state: &BundleState) -> Vec<Vec<f64>> {
        let cameras = self.views.iter().enumerate();
        cameras
            .map(|(camera, boards)| {
                let to_camera = self.to_camera(state, camera);
                let boards = boards.iter().zip(&state.boards);
                boards
                    .map(|(view, board)| {
                        let motor = to_camera * *board;
                        let squared = |seen: &SeenPoint| {
                            let place = motor.transform(self.places[seen.point]);
                            match state.cameras[camera].project(place) {
                                Ok([u, v]) => {
                                    (u - seen.pixel[0]).powi(2) + (v - seen.pixel[1]).powi(2)
                                }
                                Err(_) => f64::INFINITY,
                            }
                        };
                        view.points().iter().map(squared).sum()
                    })
                    .collect()
            })
            .collect()
    }

    /// The motor from the first camera's frame into that of a camera.
    fn to_camera(&self, state: &BundleState, camera: usize) -> Motor<f64> {
        match camera {
            0 => Motor::default(),
            other => state.motions[other - 1],
        }
    }
}

impl Problem for Bundle<'_> {
    type State = BundleState;

    fn columns(&self) -> Columns {
        Columns::grouped(self.shared(), self.views[0].len(), TWIST)
    }

    fn evaluate(&self, state: &BundleState, equations: &mut Equations) -> Option<()> {
        let shared = self.shared();
        let mut derivatives: Vec<(usize, [f64; 2])> = Vec::new();
        for (camera, boards) in self.views.iter().enumerate() {
            let to_camera = self.to_camera(state, camera);
            let to_first = to_camera.reverse();
            let first_column = self.first_column(camera);
            for (board, view) in boards.iter().enumerate() {
                let board_column = shared + TWIST * board;
                for SeenPoint { point, pixel } in view.points() {
                    let in_first = state.boards[board].transform(self.places[*point]);
                    let in_frame = to_camera.transform(in_first);
                    let FrameProjection {
                        pixel: seen,
                        by_point,
                        by_parameters,
                    } = state.cameras[camera]
                        .project_with_derivatives(in_frame)
                        .ok()?;
                    derivatives.clear();
                    for (k, &parameter) in self.free[camera].iter().enumerate() {
                        let by_parameter = by_parameters.map(|row| row[parameter]);
                        derivatives.push((first_column + k, by_parameter));
                    }
                    let by_point = by_point.map(Vector::from);
                    if camera > 0 {
                        let column = self.motion_column(camera);
                        push_twist(&mut derivatives, column, in_frame, by_point);
                    }
                    let by_point = by_point.map(|row| rotated(to_first, row));
                    push_twist(&mut derivatives, board_column, in_first, by_point);
                    equations.add([seen[0] - pixel[0], seen[1] - pixel[1]], &derivatives);
                }
            }
        }
        Some(())
    }

    fn stepped(&self, state: &BundleState, step: &[f64]) -> Option<BundleState> {
        let mut next = state.clone();
        for (camera, free) in self.free.iter().enumerate() {
            if free.is_empty() {
                continue;
            }
            let own = &state.cameras[camera];
            let mut parameters = own.parameters();
            for (k, &parameter) in free.iter().enumerate() {
                parameters[parameter] += step[self.first_column(camera) + k];
            }
            let count = own.parameter_count();
            next.cameras[camera] = own.with_parameters(&parameters[..count]).ok()?;
        }
        let twists = step[self.motion_column(1)..].chunks_exact(TWIST);
        for (motion, twist) in next.motions.iter_mut().zip(twists) {
            *motion = exponential(twist) * *motion;
        }
        let twists = step[self.shared()..].chunks_exact(TWIST);
        for (board, twist) in next.boards.iter_mut().zip(twists) {
            *board = exponential(twist) * *board;
        }
        Some(next)
    }
}

/// A vector after the rotation of a motor.
fn rotated(motor: Motor<f64>, vector: Vector<f64>) -> Vector<f64> {
    let direction = Direction::from_vector(vector.coordinates());
    Vector::from(motor.transform(direction).vector())
}

/// Adds the derivatives of a pixel by the twist of a frame, from those by the place in the frame.
fn push_twist(
    derivatives: &mut Vec<(usize, [f64; 2])>,
    column: usize,
    place: Point<f64>,
    by_point: [Vector<f64>; 2],
) {
    let rows = by_point.map(|row| by_twist(place.into(), row));
    derivatives.extend((0..TWIST).map(|k| (column + k, rows.map(|row| row[k]))));
}

/// The motor of the first six numbers as a twist.
fn exponential(twist: &[f64]) -> Motor<f64> {
    let part = |first: usize| Direction::new(twist[first], twist[first + 1], twist[first + 2]);
    MotorGenerator::from_velocities(part(0), part(3)).exp()
}
