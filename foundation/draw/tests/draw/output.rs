//! Pictures and pages: their structure, escaping and colours, and pictures of any scene.

use ga_draw::{Colour, PALETTE, Scene, Shape, Style};
use ga_runtime::cga3::{Point, Sphere};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use crate::{assert_well_formed, parsed};

#[test]
fn a_ball_is_a_circle_of_its_radius() {
    // Along parallel rays a unit sphere is a disc that fills the height of the picture but for its
    // margins.
    let mut scene = Scene::new("");
    scene.size = [400, 400];
    scene.view.projection = ga_draw::Projection::Orthographic;
    let sphere = Sphere::from_centre_radius(Point::new(5.0, 6.0, 7.0), 2.0);
    scene.add(sphere, Style::default()).unwrap();
    let svg = scene.to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let ball = document
        .descendants()
        .find(|node| node.attribute("id") == Some("ball0"))
        .unwrap();
    let data = ball.attribute("d").unwrap().replace(['M', 'L', 'Z'], " ");
    let numbers: Vec<f64> = data
        .split_whitespace()
        .map(|number| number.parse().unwrap())
        .collect();
    assert_eq!(numbers.len(), 2 * 97);
    let radii: Vec<f64> = numbers
        .chunks(2)
        .map(|p| (p[0] - 200.0).hypot(p[1] - 200.0))
        .collect();
    assert!(radii.iter().all(|radius| (radius - radii[0]).abs() < 0.2));
    assert!((radii[0] - 166.0).abs() < 1.0, "{}", radii[0]);
}

#[test]
fn texts_stay_texts() {
    let evil = "</script><svg onload=\"x()\"> & 'q' \u{1}";
    let mut scene = Scene::new(evil);
    scene.description = evil.to_owned();
    scene
        .add(Point::new(0.0, 0.0, 0.0), Style::labelled(evil))
        .unwrap();
    let svg = scene.to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let read = evil.replace('\u{1}', "\u{fffd}");
    let texts = |name| {
        document
            .descendants()
            .filter(move |node| node.has_tag_name(("http://www.w3.org/2000/svg", name)))
    };
    assert_eq!(texts("title").next().unwrap().text(), Some(read.as_str()));
    assert_eq!(texts("desc").next().unwrap().text(), Some(read.as_str()));
    let html = scene.to_html();
    assert!(!html.contains("<svg onload") && !html.contains(evil));
    assert_eq!(html.matches("</script>").count(), 2);
}

#[test]
fn the_page_asks_for_nothing() {
    let html = parsed(r#"{"point": [1, 2, 3]}"#).unwrap().to_html();
    let links = html.matches("http").count();
    // The name space of the picture and the policy that forbids requests.
    assert_eq!(links, 2);
    assert!(html.contains("default-src 'none'") && html.contains("http-equiv"));
}

#[test]
fn colours_stand_out_against_both_grounds() {
    let channel = |value: u8| {
        let x = f64::from(value) / 255.0;
        if x <= 0.04045 {
            x / 12.92
        } else {
            ((x + 0.055) / 1.055).powf(2.4)
        }
    };
    let luminance =
        |Colour([r, g, b])| 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b) + 0.05;
    for colour in PALETTE {
        let own = luminance(colour);
        assert!(luminance(Colour([255; 3])) / own >= 3.0, "{colour}");
        assert!(
            own / luminance(Colour([0x14, 0x17, 0x1c])) >= 3.0,
            "{colour}"
        );
    }
}

#[test]
fn no_two_colours_of_a_dozen_elements_are_alike() {
    assert!(PALETTE.len() >= 12);
    for (k, colour) in PALETTE.iter().enumerate() {
        for other in &PALETTE[..k] {
            let squares = (0..3).map(|k| (f64::from(colour.0[k]) - f64::from(other.0[k])).powi(2));
            assert!(squares.sum::<f64>() > 1600.0, "{colour} and {other}");
        }
    }
}

fn shape() -> impl Strategy<Value = Shape> {
    let number = prop_oneof![-10.0..10.0, -1e90..1e90, -1e-90..1e-90, Just(0.0)];
    let place = proptest::array::uniform3(number).prop_map(Point::from);
    let side = proptest::array::uniform3(-1.0..1.0).prop_map(Vector::from);
    let side = side.prop_filter_map("no direction", Vector::normalized);
    let radius = prop_oneof![0.0..10.0, 0.0..1e90, Just(0.0)];
    (place.clone(), side, radius, any::<bool>(), 0..8, place).prop_map(
        |(centre, side, radius, imaginary, kind, other)| match kind {
            0 => Shape::Point { at: centre },
            1 => Shape::PointPair {
                centre,
                direction: side,
                radius,
                imaginary,
            },
            2 => Shape::Circle {
                centre,
                normal: side,
                radius,
                imaginary,
            },
            3 => Shape::Sphere {
                centre,
                radius,
                imaginary,
            },
            4 => Shape::Line {
                support: centre,
                direction: side,
            },
            5 => Shape::Plane {
                support: centre,
                normal: side,
            },
            6 => Shape::Trajectory {
                points: vec![centre, other],
                frames: vec![(other, [side; 3])],
            },
            _ => Shape::Direction {
                vector: centre.into(),
            },
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_scene_is_well_formed(
        shapes in proptest::collection::vec(shape(), 0..6),
        label in any::<String>(),
        (azimuth, elevation) in (-400.0..400.0, -90.0..90.0),
        parallel in any::<bool>(),
    ) {
        let mut scene = Scene::new(label.clone());
        scene.view.azimuth = azimuth;
        scene.view.elevation = elevation;
        if parallel {
            scene.view.projection = ga_draw::Projection::Orthographic;
        }
        (scene.axes, scene.grid) = (parallel, !parallel);
        for shape in shapes {
            scene.add(shape, Style::labelled(label.as_str())).unwrap();
        }
        let svg = scene.to_svg();
        assert_well_formed(&svg);
        prop_assert_eq!(svg, scene.to_svg());
        prop_assert!(!scene.to_html().contains("null,null"));
    }
}
