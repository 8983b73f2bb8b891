//! Trajectories.

use ga_runtime::cga3::{Line, Motor, MotorGenerator, Point};
use ga_runtime::geometry::Screw;
use ga_runtime::vga3::Vector;

use super::element::motor;
use super::error::ElementProblem;
use super::format::{Place, ScrewText, TrajectoryText};
use crate::shape::{NotDrawable, Trajectory};

/// The largest number of steps of a trajectory.
const MOST_STEPS: u32 = 20_000;

pub(super) fn trajectory(text: TrajectoryText) -> Result<Trajectory, ElementProblem> {
    let count = |steps: Option<u32>, default| match steps.unwrap_or(default) {
        steps @ 1..=MOST_STEPS => Ok(steps),
        steps => Err(ElementProblem::Number {
            member: "steps",
            value: steps.into(),
            expected: "from 1 to 20000",
        }),
    };
    let carried =
        |path: Trajectory, point: Place, frames| path.carrying(point.into()).with_frames(frames);
    Ok(match text {
        TrajectoryText::Points { points } => {
            Trajectory::through(points.into_iter().map(Point::from))
        }
        TrajectoryText::Motors {
            motors,
            steps,
            point,
            frames,
        } => {
            let steps = count(steps, 32)?;
            let motors = motors.iter().map(motor).collect::<Result<Vec<_>, _>>()?;
            let mut path: Vec<Motor<f64>> = motors.first().copied().into_iter().collect();
            for pair in motors.windows(2) {
                let t = |k: u32| f64::from(k) / f64::from(steps);
                path.extend((1..=steps).map(|k| pair[0].interpolate(pair[1], t(k))));
            }
            carried(Trajectory::of_motors(path), point, frames)
        }
        TrajectoryText::Screw {
            screw,
            steps,
            point,
            frames,
        } => {
            let default = (screw.degrees.abs() / 5.0).clamp(48.0, 2000.0) as u32;
            let steps = count(steps, default)? as usize;
            carried(Trajectory::screw(generator(&screw)?, steps), point, frames)
        }
    })
}

fn generator(screw: &ScrewText) -> Result<MotorGenerator<f64>, ElementProblem> {
    let axis = Vector::from(screw.axis).normalized();
    let axis = axis.ok_or(ElementProblem::NoDirection("axis"))?;
    let screw = Screw {
        axis: Line::from_point_direction(screw.through.into(), axis.into()),
        angle: screw.degrees.to_radians(),
        displacement: screw.shift,
    };
    let generator = screw.generator();
    Ok(generator.ok_or(NotDrawable::NotFinite(f64::INFINITY))?)
}
