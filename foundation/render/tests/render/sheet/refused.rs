//! Sheets that cannot be drawn.

use ga_render::sheet::{Kind, Layout, Options, SheetError, contact_sheet};
use ga_render::{RenderError, Style};

use super::{TRIANGLES, frames, kinds, small, walk};

#[test]
fn bad_input_is_named() {
    let positions = walk(3, [0.1, 0.0, 0.0]);
    let good = kinds(2, 1);
    let make = |kinds: &[Kind], positions: &[Vec<[f64; 3]>], options: &Options| {
        contact_sheet(&frames(kinds, positions), &TRIANGLES, options).map(|_| ())
    };
    assert_eq!(make(&[], &[], &small()), Err(SheetError::NoFrames));
    for wrong in [
        [
            Kind::Key,
            Kind::InBetween { step: 1, steps: 3 },
            Kind::InBetween { step: 2, steps: 3 },
        ],
        [Kind::InBetween { step: 1, steps: 2 }, Kind::Key, Kind::Key],
    ] {
        assert_eq!(
            make(&wrong, &positions, &small()),
            Err(SheetError::NotKeyToKey)
        );
    }
    assert_eq!(
        make(&[Kind::Key], &positions, &small()),
        Err(SheetError::NotKeyToKey)
    );
    let columns = |columns| Options {
        layout: Layout::Columns(columns),
        ..small()
    };
    assert!(matches!(
        make(&good, &positions, &columns(0)),
        Err(SheetError::Size { columns: 0, .. })
    ));
    let large = Options {
        style: Style {
            width: 16_000,
            height: 16_000,
            supersampling: 1,
            ..Style::default()
        },
        ..columns(3)
    };
    assert_eq!(
        make(&good, &positions, &large),
        Err(SheetError::Size {
            columns: 3,
            rows: 1
        })
    );

    let mut broken = positions.clone();
    broken[1][4][0] = f64::NAN;
    assert_eq!(
        make(&good, &broken, &small()),
        Err(SheetError::Frame {
            number: 1,
            source: RenderError::Position {
                object: 0,
                vertex: 4
            }
        })
    );
    let mut short = positions.clone();
    short[2].pop();
    let source = RenderError::Triangle {
        object: 0,
        triangle: 4,
        vertex: 5,
        vertices: 5,
    };
    assert_eq!(
        make(&good, &short, &small()),
        Err(SheetError::Frame { number: 2, source })
    );
    let nowhere = vec![vec![[1.0; 3]; 6]; 3];
    assert!(matches!(
        make(&good, &nowhere, &small()),
        Err(SheetError::Picture(RenderError::Camera(_)))
    ));
    let mut bones = frames(&good, &positions);
    bones[1].bones = &[[[0.0; 3], [f64::INFINITY, 0.0, 0.0]]];
    assert_eq!(
        contact_sheet(&bones, &TRIANGLES, &small()).map(|_| ()),
        Err(SheetError::Frame {
            number: 1,
            source: RenderError::Bone { bone: 0 }
        })
    );
}
