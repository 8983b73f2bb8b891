//! Errors as they are printed.

use std::error::Error as Cause;

use anyhow::Error;
use ga_body::format::{JointsError, JointsReadError};
use ga_camera::format::CameraFileError;
use ga_compiler::source::SourceError;
use ga_files::ReadError;
use ga_render::RenderError;
use ga_render::view_file::ViewFileError;

/// The text of an error, which starts with `error: `. Errors in source text show the lines that
/// they are in; any other error is one line.
pub(crate) fn text(error: &Error) -> String {
    match error.downcast_ref::<SourceError>() {
        Some(SourceError::Faulty(faults)) => faults.to_string(),
        _ => format!("error: {}", one_line(error)),
    }
}

/// The error and its causes, outermost first, in one line, and what the program can do about it. A
/// cause is left out where the message before it ends with it.
fn one_line(error: &Error) -> String {
    let mut line = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if line.is_empty() {
            line = cause;
        } else if !line.ends_with(&cause) {
            line.push_str(": ");
            line.push_str(&cause);
        }
    }
    if let Some(advice) = error.chain().find_map(advice) {
        line.push_str(": ");
        line.push_str(advice);
    }
    line.replace(['\r', '\n'], " ")
}

/// What the program has for an error of a library, which knows no options.
fn advice(cause: &(dyn Cause + 'static)) -> Option<&'static str> {
    const UNDISTORT: &str = "`nullcone stereo undistort` makes pictures without it and writes \
                             their camera (--new-camera)";
    let of_camera = |error: &CameraFileError| match error {
        CameraFileError::UnclearLens(_) => {
            Some("--lens radial-tangential or --lens fisheye says it")
        }
        CameraFileError::Skew { .. } => Some("`nullcone render` draws with it"),
        _ => None,
    };
    let of_render = |error: &RenderError| matches!(error, RenderError::Lens).then_some(UNDISTORT);
    if let Some(error) = cause.downcast_ref() {
        return of_camera(error);
    }
    if let Some(error) = cause.downcast_ref() {
        return of_render(error);
    }
    if let Some(JointsReadError::File(ReadError::Contents { problem, .. })) = cause.downcast_ref() {
        let is_unknown = matches!(problem, JointsError::UnknownCount { .. });
        return is_unknown.then_some("--model NAME says it");
    }
    match (cause.downcast_ref(), cause.downcast_ref()) {
        (Some(JointsError::Camera(error)), _) | (_, Some(ViewFileError::Camera(error))) => {
            of_camera(error)
        }
        (_, Some(ViewFileError::View(error))) => of_render(error),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cause_is_not_repeated() {
        let cause = std::io::Error::other("the disk is full");
        let error = Error::new(cause).context("cannot write a: the disk is full");
        assert_eq!(
            one_line(&error.context("no model")),
            "no model: cannot write a: the disk is full"
        );
    }
}
