use ga_character::Overlay;
use ga_image::colour::LinearColour;
use ga_render::Visibility;

use super::{assert_near, character, journey};

fn channels(colour: LinearColour) -> [f64; 3] {
    [colour.red, colour.green, colour.blue]
}

#[test]
fn a_path_is_where_the_joint_was_during_the_last_second() {
    let character = character();
    let clip = journey(2.0, &[[0.0; 3], [6.0, 0.0, 0.0]]);
    let overlay = Overlay {
        character: &character,
        clip: &clip,
        bones: false,
        joints: vec![1],
    };
    // The joint goes 3 m a second: the path of the second before 1.5 s begins at 1.5 m.
    let marks = overlay.marks(1.5, &clip.sample(1.5)).unwrap();
    assert!(marks.bones.is_empty());
    let lines = marks.lines(1000);
    assert_eq!(lines.len(), 30);
    for (index, line) in lines.iter().enumerate() {
        let [newer, older] = line.points else {
            panic!("a piece has two ends")
        };
        let metres = 0.1 * index as f64;
        assert_near(*older, [1.5 + metres, 1.0, 0.0], 1e-12);
        assert_near(*newer, [1.6 + metres, 1.0, 0.0], 1e-12);
        // From 2 px to 8 px, less one step since each piece is as wide as its older end.
        let width = 2.0 + 0.2 * index as f64;
        assert!((line.width - width).abs() < 1e-9, "{} {width}", line.width);
        assert_eq!(line.visibility, Visibility::OnTop);
        // Towards its older end it is three fifths of the way to white.
        let part = 0.6 * (30 - index) as f64 / 30.0;
        let colour = LinearColour::from_srgb([214, 51, 39]).lerp(LinearColour::WHITE, part);
        assert_near(channels(line.colour), channels(colour), 1e-9);
    }
    // No line is thinner than a pixel.
    assert!(marks.lines(10).iter().all(|line| line.width == 1.0));
}

#[test]
fn a_path_begins_with_the_motion() {
    let character = character();
    let clip = journey(2.0, &[[0.0; 3], [6.0, 0.0, 0.0]]);
    let overlay = Overlay {
        character: &character,
        clip: &clip,
        bones: true,
        joints: vec![0; 7],
    };
    // Exactly 15 steps of a thirtieth of a second lie before half a second.
    let marks = overlay.marks(0.5, &clip.sample(0.5)).unwrap();
    let lines = marks.lines(1000);
    assert_eq!(lines.len(), 15 * 7);
    assert_near(lines[0].points[1], [0.0; 3], 1e-12);
    assert_near(lines[104].points[0], [1.5, 0.0, 0.0], 1e-12);
    assert!(
        overlay
            .marks(0.0, &clip.sample(0.0))
            .unwrap()
            .lines(9)
            .is_empty()
    );
    // There are six colours; the last piece drawn is of the first joint again.
    let colours: Vec<_> = lines[98..].iter().map(|line| line.colour).collect();
    assert_eq!(colours[0], colours[6]);
    for other in 1..6 {
        assert_ne!(colours[0], colours[other]);
    }
    // The bones are those of the pose.
    assert_eq!(marks.bones.len(), 2);
    assert_near(marks.bones[1][0], [1.5, 1.0, 0.0], 1e-12);
    assert_near(marks.bones[1][1], [1.5, 2.0, 0.0], 1e-12);
}
