use ga_character::report::{AnimationReport, FigureReport};
use ga_character::{Animation, Figure, Storyboard};

use super::{character, journey};

#[test]
fn a_figure_and_its_motion_are_what_they_are() {
    let figure = Figure::new("square", character());
    let report = FigureReport::new(&figure);
    assert_eq!((report.name.as_str(), report.group), ("square", None));
    assert_eq!(report.metres_per_unit, 1.0);
    assert_eq!(report.height_metres, 2.0);
    assert_eq!([report.vertices, report.faces, report.triangles], [4, 2, 2]);
    assert_eq!([report.joints, report.influences_max], [2, 1]);

    let clip = journey(0.25, &[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    let animation = Animation {
        name: "go".to_owned(),
        storyboard: Storyboard::of_keys(&clip, 1),
        clip,
        title: String::new(),
        in_between_deviation: Some(0.5),
    };
    let report = AnimationReport::new(&figure, &animation).unwrap();
    assert_eq!(report.name, "go");
    assert_eq!(report.frames, 3);
    assert_eq!(report.frames_per_second, 4.0);
    assert_eq!(report.duration_seconds, 0.5);
    assert_eq!(report.in_between_deviation_max_metres, Some(0.5));
}
