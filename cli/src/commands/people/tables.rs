//! Where the joints are, as tables.

use ga_files::table::{Cell, Separator, row};

use super::figure::Figure;

/// Places are written to the micrometre.
const PARTS_OF_A_METRE: f64 = 1e6;

/// A table with a row for each frame, in metres.
pub(super) fn csv(figure: &Figure, frames_per_second: f64) -> String {
    let names = figure.names[..figure.joints].iter();
    let axes = names.flat_map(|name| ["x", "y", "z"].map(|axis| format!("{name}_{axis}")));
    let header = ["frame", "time_seconds"].map(str::to_owned);
    let header = header.into_iter().chain(axes).map(Cell::Text);
    let rows = figure.frames.iter().enumerate().map(|(frame, places)| {
        let numbers = [frame as f64, frame as f64 / frames_per_second];
        let numbers = numbers.into_iter().chain(micrometres(figure, places));
        row(numbers.map(Cell::Number), Separator::Comma)
    });
    row(header, Separator::Comma) + &rows.collect::<String>()
}

/// The same as TRC, which OpenSim reads: in millimetres, with frames from 1.
pub(super) fn trc(figure: &Figure, frames_per_second: f64, file: &str) -> String {
    let (frames, markers) = (figure.frames.len(), figure.joints);
    let names = figure.names[..markers].iter();
    let words = |words: &[&str]| {
        let words = words.iter().map(|word| Cell::Text((*word).to_owned()));
        words.collect::<Vec<_>>()
    };
    let count = |count: usize| Cell::Number(count as f64);
    let rate = || Cell::Number(frames_per_second);
    let mut of_names = words(&["Frame#", "Time"]);
    of_names.extend(names.flat_map(|name| {
        let name = Cell::Text(name.clone());
        [name, Cell::Missing, Cell::Missing]
    }));
    let mut axes = vec![Cell::Missing, Cell::Missing];
    axes.extend(
        (1..=markers).flat_map(|k| ["X", "Y", "Z"].map(|axis| Cell::Text(format!("{axis}{k}")))),
    );
    let mut rows = vec![
        words(&["PathFileType", "4", "(X/Y/Z)", file]),
        words(&[
            "DataRate",
            "CameraRate",
            "NumFrames",
            "NumMarkers",
            "Units",
            "OrigDataRate",
            "OrigDataStartFrame",
            "OrigNumFrames",
        ]),
        vec![
            rate(),
            rate(),
            count(frames),
            count(markers),
            Cell::Text("mm".to_owned()),
            rate(),
            count(1),
            count(frames),
        ],
        of_names,
        axes,
    ];
    rows.extend(figure.frames.iter().enumerate().map(|(frame, places)| {
        let millimetres = micrometres(figure, places).map(|metres| (1e6 * metres).round() / 1e3);
        let start = [(frame + 1) as f64, frame as f64 / frames_per_second];
        let numbers = start.into_iter().chain(millimetres);
        numbers.map(Cell::Number).collect()
    }));
    let rows = rows.into_iter();
    rows.map(|cells| row(cells, Separator::Tab)).collect()
}

/// The coordinates of the joints in metres, to the micrometre.
fn micrometres<'a>(figure: &Figure, places: &'a [[f64; 3]]) -> impl Iterator<Item = f64> + 'a {
    let coordinates = places[..figure.joints].iter().flatten();
    coordinates.map(|metres| (PARTS_OF_A_METRE * metres).round() / PARTS_OF_A_METRE)
}
