//! Records and summaries as JSON and CSV.

use ga_files::table::{self, Cell, Separator};
use serde_json::{Map, Value, json};

use super::{Dimension, Level, Record, Row, Scale, Summary, Viewing};

impl Record {
    /// The frame and its rows, by the names of quantities; numbers are null where they are not
    /// known.
    #[must_use]
    pub fn json(&self) -> Value {
        let rows = Dimension::ALL
            .into_iter()
            .map(|dimension| (dimension.name().to_owned(), row(self, dimension)));
        json!({ "frame": self.frame, "rows": rows.collect::<Map<_, _>>() })
    }

    /// The names of the columns of [`csv`](Self::csv), as a line with its end.
    #[must_use]
    pub fn csv_header() -> String {
        let mut names = vec!["frame".to_owned(), "time_seconds".to_owned()];
        for dimension in Dimension::ALL {
            let name = dimension.name();
            names.push(format!("{name}_score"));
            names.push(format!("{name}_{}", dimension.unit().name()));
        }
        table::row(names.into_iter().map(Cell::Text), Separator::Comma)
    }

    /// The scores and raw numbers of the frame, as a line with its end; a state stands for a score
    /// that is missing.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut cells = vec![
            Cell::Number(self.frame as f64),
            Cell::Number(self.time_seconds),
        ];
        for Row { score, raw, .. } in &self.rows {
            cells.push(Cell::Text(match score {
                Ok(score) => score.to_string(),
                Err(missing) => missing.to_string(),
            }));
            cells.push(Cell::from(*raw));
        }
        table::row(cells, Separator::Comma)
    }
}

impl Summary {
    /// All rows by the names of quantities, with the limits that hold for these viewers.
    #[must_use]
    pub fn json(&self, viewing: &Viewing) -> Value {
        let rows = Dimension::ALL.into_iter().map(|dimension| {
            let row = self.row(dimension);
            let scale = Scale::of(dimension, viewing);
            let [green, orange, red] = row.levels;
            let value = json!({
                "mean_score": row.mean_score(),
                "level": row.mean_level().map(Level::name),
                "mean_raw": row.mean_raw(),
                "unit": dimension.unit().name(),
                "comfortable": scale.map(|scale| scale.comfortable()),
                "limit": scale.map(|scale| scale.limit()),
                "frames_green": green,
                "frames_orange": orange,
                "frames_red": red,
                "frames_without_score": self.frames - row.scored,
                "worst_frame": row.worst.map(|(_, frame)| frame),
            });
            (dimension.name().to_owned(), value)
        });
        json!({
            "frames": self.frames,
            "shots": self.shots,
            "notes": super::report::notes(self),
            "screen_width_metres": viewing.width(),
            "distance_metres": viewing.distance(),
            "rows": rows.collect::<Map<_, _>>(),
        })
    }
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
            object.insert("reason".into(), missing.reason().into());
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
