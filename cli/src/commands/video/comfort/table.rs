//! The summary in the shape of Cui's table 6.

use std::fmt::Write;

use ga_video::comfort::{Dimension, Level, Scale, Summary, Viewing};
use serde_json::{Map, Value, json};

/// The mean of each row, how many frames are green, orange and red, and the worst frame.
pub(super) fn text(summary: &Summary, viewing: &Viewing) -> String {
    let mut text = format!(
        "{} frames, {} shots; a screen {:.2} m wide at {:.2} m\n\n{:<20} {:>5} {:<7} {:>6} {:>6} \
         {:>6} {:>8} {:>12}\n",
        summary.frames,
        summary.shots,
        viewing.width(),
        viewing.distance(),
        "",
        "mean",
        "",
        "green",
        "orange",
        "red",
        "no score",
        "worst frame"
    );
    for dimension in Dimension::ALL {
        let row = summary.row(dimension);
        let [green, orange, red] = row.levels;
        let missing = summary.frames - row.scored;
        let (mean, level) = match row.mean_score() {
            Some(mean) => (
                format!("{mean:.1}"),
                row.mean_level().map_or("", Level::name),
            ),
            None => ("–".into(), ""),
        };
        let worst = row.worst.map_or("–".into(), |(_, frame)| frame.to_string());
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{:<20} {mean:>5} {level:<7} {green:>6} {orange:>6} {red:>6} {missing:>8} {worst:>12}",
            dimension.name().replace('_', " ")
        );
    }
    text
}

/// The same as JSON, with the limits that were used.
pub(super) fn json(summary: &Summary, viewing: &Viewing) -> Value {
    let rows: Map<String, Value> = Dimension::ALL
        .into_iter()
        .map(|dimension| {
            let row = summary.row(dimension);
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
                "frames_without_score": summary.frames - row.scored,
                "worst_frame": row.worst.map(|(_, frame)| frame),
            });
            (dimension.name().to_owned(), value)
        })
        .collect();
    json!({
        "frames": summary.frames,
        "shots": summary.shots,
        "screen_width_metres": viewing.width(),
        "distance_metres": viewing.distance(),
        "rows": rows,
    })
}
