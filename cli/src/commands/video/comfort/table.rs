//! The summary in the shape of Cui's table 6.

use ga_video::comfort::{Dimension, Level, Summary, Viewing};

use crate::counted::counted;

/// The mean of each row, how many frames are green, orange and red, and the worst frame.
pub(super) fn text(summary: &Summary, viewing: &Viewing) -> String {
    let mut text = format!(
        "{}, {}; a screen {:.2} m wide at {:.2} m\n\n{:<20} {:>5} {:<7} {:>6} {:>6} \
         {:>6} {:>8} {:>12}\n",
        counted(summary.frames, "frame"),
        counted(summary.shots, "shot"),
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
        text += &format!(
            "{:<20} {mean:>5} {level:<7} {green:>6} {orange:>6} {red:>6} {missing:>8} {worst:>12}\n",
            dimension.name().replace('_', " ")
        );
    }
    text
}
