use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_character::pictures::{FILM_SIZE, film, sheet};
use ga_character::{Animation, CharacterError, Figure, Overlay, Storyboard};
use ga_image::plane::Plane;
use ga_runtime::cga3::{Motor, Rotor};

use super::{character, journey, moved, painted};

fn animation(clip: Clip) -> Animation {
    Animation {
        name: "go".to_owned(),
        storyboard: Storyboard::of_keys(&clip, 1),
        clip,
        title: "A square".to_owned(),
        in_between_deviation: None,
    }
}

fn frames(figure: &Figure, clip: Clip) -> Vec<Plane<[u8; 3]>> {
    let animation = animation(clip);
    let overlay = Overlay {
        character: &figure.character,
        clip: &animation.clip,
        bones: false,
        joints: Vec::new(),
    };
    let mut frames = Vec::new();
    film::<Box<CharacterError>>(figure, &animation, &overlay, |number, picture| {
        assert_eq!(number, frames.len());
        frames.push(picture.clone());
        Ok(())
    })
    .unwrap();
    frames
}

/// Where a picture is clearly red, as the left half of the painted square is.
fn red(picture: &Plane<[u8; 3]>) -> Vec<bool> {
    let pixels = picture.values().iter();
    let is_red = |[r, g, b]: &[u8; 3]| {
        i16::from(*r) > 60 + i16::from(*g) && i16::from(*r) > 60 + i16::from(*b)
    };
    pixels.map(is_red).collect()
}

#[test]
fn a_film_has_a_picture_for_each_frame_that_shows_the_figure_whole() {
    let figure = painted();
    let poses = [0.0, 0.4, 0.8].map(|forward| {
        let mut pose = Pose::rest(2);
        pose.joints[1] = moved([0.0, 0.0, forward]);
        pose
    });
    let pictures = frames(&figure, Clip::new(0.1, poses.to_vec()).unwrap());
    assert_eq!(pictures.len(), 3);
    for picture in &pictures {
        assert_eq!([picture.width() as u32, picture.height() as u32], FILM_SIZE);
        let red = red(picture);
        assert!(red.iter().filter(|&&is_red| is_red).count() > 500);
        let width = picture.width();
        let at_border = |index: usize| {
            let (x, y) = (index % width, index / width);
            x == 0 || y == 0 || x == width - 1 || y == picture.height() - 1
        };
        assert!(
            !red.iter()
                .enumerate()
                .any(|(index, &is_red)| is_red && at_border(index))
        );
    }
    assert!(pictures[0] != pictures[2]);
}

/// The camera stands aside of where the figure looks, so that a figure that is rotated as a whole
/// is seen from the same side of itself.
#[test]
fn a_figure_is_seen_from_its_own_side_wherever_it_looks() {
    let figure = painted();
    let heading = |angle: f64| {
        let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).unwrap();
        let pose = Pose {
            root: Motor::from(rotor),
            ..Pose::rest(2)
        };
        let pictures = frames(&figure, Clip::new(0.1, vec![pose]).unwrap());
        red(&pictures[0])
    };
    let ahead = heading(0.0);
    let count = ahead.iter().filter(|&&is_red| is_red).count();
    for angle in [0.7, 1.57, -2.0] {
        let other = heading(angle);
        let differing = ahead.iter().zip(&other).filter(|(a, b)| a != b).count();
        assert!(differing < count / 6, "{angle}: {differing} of {count}");
    }
}

/// A square of 2 m seen 0.9 rad from aside is 2 cos 0.9 = 1.24 m wide; its nearer side, and so the
/// whole, is a little higher.
#[test]
fn the_camera_stands_aside() {
    let mut figure = painted();
    figure.paint = Some(Plane::filled(1, 1, [255, 0, 0]));
    let picture = &frames(&figure, journey(0.1, &[[0.0; 3]]))[0];
    let red = red(picture);
    let extent = |of: &dyn Fn(usize) -> usize| {
        let places = (0..red.len()).filter(|&index| red[index]).map(of);
        let (least, greatest) = places.fold((usize::MAX, 0), |(a, b), x| (a.min(x), b.max(x)));
        (greatest - least) as f64
    };
    let width = picture.width();
    let ratio = extent(&|index| index % width) / extent(&|index| index / width);
    assert!((0.4..0.7).contains(&ratio), "{ratio}");
}

#[test]
fn a_sheet_has_all_moments_and_marks_lie_over_them() {
    let figure = Figure::new("square", character());
    let animation = animation(journey(0.1, &[[0.0; 3], [0.5, 0.0, 0.0]]));
    let overlay = |bones, joints| Overlay {
        character: &figure.character,
        clip: &animation.clip,
        bones,
        joints,
    };
    let (plain, warnings) = sheet(&figure, &animation, &overlay(false, Vec::new())).unwrap();
    assert!(warnings.is_empty());
    assert_eq!(plain.name, "sheet.png");
    let picture = ga_image::png::decode(&plain.contents).unwrap();
    let [width, height] = plain.pixels.unwrap();
    assert_eq!([picture.width(), picture.height()], [width, height]);
    // Five moments of 240 × 320 pixels in one row, and their depth in another.
    assert!((5 * 240..5 * 240 + 200).contains(&width), "{width}");
    assert!((2 * 320..3 * 320).contains(&height), "{height}");
    for (bones, joints) in [(false, vec![1]), (true, Vec::new())] {
        let (marked, _) = sheet(&figure, &animation, &overlay(bones, joints)).unwrap();
        assert_eq!(marked.pixels, plain.pixels);
        assert!(marked.contents != plain.contents);
    }

    let other = Clip::new(0.1, vec![Pose::rest(3)]).unwrap();
    let other = self::animation(other);
    let overlay = overlay(false, Vec::new());
    assert!(sheet(&figure, &other, &overlay).is_err());
}
