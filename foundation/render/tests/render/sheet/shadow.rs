//! Shadows of the figures of a sheet.

use ga_render::sheet::{Kind, Layout, Options};
use ga_render::{Style, ViewDirection};

use super::{sheet, small, walk};

/// The pixels of which the shadow takes light away.
fn shadowed(positions: &[Vec<[f64; 3]>], options: &Options) -> Vec<Vec<bool>> {
    let kinds = vec![Kind::Key; positions.len()];
    let draw = |shadow: f64| {
        let style = Style {
            shadow,
            occlusion: 0.0,
            ..options.style
        };
        let options = Options {
            style,
            ..options.clone()
        };
        sheet(&kinds, positions, &options).pictures
    };
    let darker = |a: &[u8; 3], b: &[u8; 3]| a.iter().zip(b).any(|(a, b)| a < b);
    draw(0.5)
        .iter()
        .zip(draw(1e-9))
        .map(|(with, without)| {
            let pixels = with.colour.values().iter().zip(without.colour.values());
            pixels.map(|(a, b)| darker(a, b)).collect()
        })
        .collect()
}

#[test]
fn the_shadow_stays_inside_every_picture() {
    for azimuth in 0..8 {
        for step in [[0.0; 3], [0.2, 0.0, 0.1]] {
            let options = Options {
                layout: Layout::Columns(3),
                view: ViewDirection {
                    azimuth: f64::from(azimuth),
                    elevation: 0.3,
                },
                ..small()
            };
            for shadow in shadowed(&walk(3, step), &options) {
                assert!(shadow.iter().any(|&dark| dark));
                for (pixel, dark) in shadow.into_iter().enumerate() {
                    let (column, row) = (pixel % 48, pixel / 48);
                    let at_border = column == 0 || row == 0 || column == 47 || row == 63;
                    assert!(!(dark && at_border), "azimuth {azimuth}, ({column}, {row})");
                }
            }
        }
    }
}
