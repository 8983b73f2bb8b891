//! One line for each frame.

use anyhow::Result;
use ga_files::table::{self, Cell, Separator};
use ga_video::comfort::{Dimension, Record, Row};
use serde_json::{Map, Value, json};

/// The record of a frame as a line of JSON.
pub(super) fn json(record: &Record) -> Result<String> {
    let rows: Map<String, Value> = Dimension::ALL
        .into_iter()
        .map(|dimension| (dimension.name().into(), row(record, dimension)))
        .collect();
    let line = json!({ "frame": record.frame, "rows": rows });
    Ok(serde_json::to_string(&line)? + "\n")
}

fn row(record: &Record, dimension: Dimension) -> Value {
    let row = record.row(dimension);
    let mut object = Map::new();
    match row.score {
        Ok(score) => {
            object.insert("score".into(), score.number().into());
            object.insert("level".into(), score.level().name().into());
        }
        Err(missing) => {
            object.insert("score".into(), Value::Null);
            object.insert("state".into(), missing.name().into());
        }
    }
    object.insert("raw".into(), number(row.raw));
    object.insert("unit".into(), row.unit().name().into());
    for (name, value) in details(record, dimension) {
        object.insert(name.into(), number(value));
    }
    if dimension == Dimension::Stereoscopy {
        object.insert("verdict".into(), record.stereoscopy.name().into());
    }
    Value::Object(object)
}

/// What is stated beside the raw number.
fn details(record: &Record, dimension: Dimension) -> Vec<(&'static str, Option<f64>)> {
    let measures = &record.measures;
    let geometry = measures.geometry.as_ref();
    match dimension {
        Dimension::Brightness => {
            let offset = measures.photometry.as_ref().map(|found| found.offset_codes);
            vec![("offset_codes", offset)]
        }
        Dimension::Vertical => vec![
            ("shift_px", geometry.map(|found| found.shift_px)),
            (
                "rotation_degrees",
                geometry.map(|found| found.rotation_degrees),
            ),
            ("zoom_percent", geometry.map(|found| found.zoom_percent)),
        ],
        Dimension::Asynchrony => {
            let delay = record.asynchrony.delay();
            vec![("frames", delay.map(|delay| delay.frames))]
        }
        Dimension::ParallaxDeviation => {
            let parallax = measures.parallax.as_ref();
            vec![(
                "median_px",
                parallax.map(|found| found.median_disparity_px()),
            )]
        }
        Dimension::FocalGap => vec![
            ("sharpness_log2", measures.sharpness_log2),
            ("zoom_percent", geometry.map(|found| found.zoom_percent)),
        ],
        Dimension::Colour
        | Dimension::Stereoscopy
        | Dimension::WeakDepth
        | Dimension::RichDepth
        | Dimension::OverConvergence
        | Dimension::OverDivergence => Vec::new(),
    }
}

/// A number, or null.
fn number(value: Option<f64>) -> Value {
    // Not −0.
    value.map_or(Value::Null, |value| (value + 0.0).into())
}

/// The names of the columns of [`csv()`].
pub(super) fn csv_header() -> String {
    let mut names = vec!["frame".to_owned(), "time_seconds".to_owned()];
    for dimension in Dimension::ALL {
        let name = dimension.name();
        names.push(format!("{name}_score"));
        names.push(format!("{name}_{}", dimension.unit().name()));
    }
    table::row(names.into_iter().map(Cell::Text), Separator::Comma)
}

/// The scores and raw numbers of a frame; a state stands for a score that is missing.
pub(super) fn csv(record: &Record) -> String {
    let mut cells = vec![
        Cell::Number(record.frame as f64),
        Cell::Number(record.time_seconds),
    ];
    for Row { score, raw, .. } in &record.rows {
        cells.push(Cell::Text(match score {
            Ok(score) => score.to_string(),
            Err(missing) => missing.to_string(),
        }));
        cells.push(Cell::from(*raw));
    }
    table::row(cells, Separator::Comma)
}
