//! Measures the accuracy of rounds over distance and size, prints the largest errors, and draws
//! them all as the picture of the page of conventions.
//!
//! `cargo run -p nullcone-tests --example limits -- ga-runtime/docs/limits.svg`, and another seed
//! than 1 as the last argument for other cases.

use std::error::Error;
use std::fmt::Write;

use nullcone_tests::limits::{Precision, Query, SIZES};
use nullcone_tests::random::SplitMix64;

/// Cases of each cell; a hundred motions take a hundred times as long as others.
const CASES: usize = 1000;

/// The number of rows, which divide the sizes evenly on a logarithmic scale.
const ROWS: usize = 9;

/// The power of ten of the least distance; a column is a power of ten.
const NEAREST: i32 = -2;

/// The largest errors of the levels, in units, and the colours of them and of larger ones: blue
/// within the limit, orange beyond it.
const LEVELS: [f64; 7] = [0.5, 1.0, 2.0, 4.0, 8.0, 64.0, 256.0];
const COLOURS: [&str; 8] = [
    "#eff3ff", "#c6dbef", "#9ecae1", "#4292c6", "#08519c", "#fdae6b", "#e6550d", "#7f2704",
];

/// Lengths in pixels: a cell, a panel with its margins, and the picture.
const CELL: usize = 13;
const PANEL: [usize; 2] = [296, 186];
const COLUMNS: usize = 3;
const PICTURE: [usize; 2] = [PANEL[0] * COLUMNS + 4, PANEL[1] * 4 + 4];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let out = arguments.next().ok_or("no picture is named")?;
    let seed = arguments.next().map_or(Ok(1), |seed| seed.parse())?;
    let [width, height] = PICTURE;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" style=\"max-width:100%\" font-family=\"sans-serif\" font-size=\"10\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for (number, query) in Query::ALL.into_iter().enumerate() {
        let corner = corner(number);
        let (single, double) = (Map::new::<f32>(query, seed), Map::new::<f64>(query, seed));
        let note = format!(
            "largest: f32 {}, f64 {}",
            single.largest(),
            double.largest()
        );
        println!("{}, {note}", title(query));
        text(
            &mut svg,
            [corner[0] + 4, corner[1] + 14],
            "font-weight=\"bold\"",
            title(query),
        )?;
        text(&mut svg, [corner[0] + 4, corner[1] + 27], "", &note)?;
        let left = corner[0] + 38;
        single.draw(&mut svg, [left, corner[1] + 34])?;
        let left = left + single.columns() * CELL + 24;
        double.draw(&mut svg, [left, corner[1] + 34])?;
        axes(&mut svg, corner)?;
    }
    legend(&mut svg, corner(Query::ALL.len()))?;
    svg += "</svg>\n";
    std::fs::write(out, svg)?;
    Ok(())
}

fn corner(panel: usize) -> [usize; 2] {
    [PANEL[0] * (panel % COLUMNS), PANEL[1] * (panel / COLUMNS)]
}

fn title(query: Query) -> &'static str {
    match query {
        Query::Made => "Sphere, circle of centre and radius",
        Query::PairThrough => "Pair of two points: ends, radius",
        Query::CircleThrough => "Circle through 3 points: centre, radius",
        Query::SphereThrough => "Sphere through 4 points: centre, radius",
        Query::SpheresMeet => "Spheres meet, radii up to 1:1000",
        Query::LargerMeetsSmaller => "The same by the larger ∨ the smaller",
        Query::PlaneMeetsSphere => "Plane meets sphere: centre, radius",
        Query::LineMeetsSphere => "Line meets sphere: the two points",
        Query::PlaneMeetsCircle => "Plane meets circle: the two points",
        Query::FirstHit => "Ray meets sphere: distance of first hit",
        Query::HundredMotions => "Sphere after a hundred rotations",
    }
}

/// The largest errors by row and column; `None` where no case was found.
struct Map {
    name: &'static str,
    cells: [Vec<Option<f64>>; ROWS],
}

impl Map {
    fn new<S: Precision>(query: Query, seed: u64) -> Self {
        let mut numbers = SplitMix64(seed);
        let columns = S::FARTHEST.log10().round() as i32 - NEAREST;
        let cases = if query == Query::HundredMotions {
            CASES / 20
        } else {
            CASES
        };
        let step = (SIZES[1] / SIZES[0]).powf(1.0 / ROWS as f64);
        let cells = std::array::from_fn(|row| {
            let cell = |column| {
                let case = |_| {
                    let distance = 10_f64.powf(f64::from(NEAREST + column) + numbers.unit());
                    let size = SIZES[0] * step.powf(row as f64 + numbers.unit());
                    query.error::<S>(distance, size, numbers.bits())
                };
                (0..cases).filter_map(case).reduce(f64::max)
            };
            (0..columns).map(cell).collect()
        });
        Self {
            name: S::NAME,
            cells,
        }
    }

    fn columns(&self) -> usize {
        self.cells[0].len()
    }

    /// The largest error; the product may say that spheres do not meet which do.
    fn largest(&self) -> String {
        let errors = self.cells.iter().flatten().flatten();
        let largest = errors.copied().fold(0.0, f64::max);
        if largest.is_finite() {
            format!("{largest:.1}")
        } else {
            "no answer".to_owned()
        }
    }

    /// Draws the cells, those of one colour as one path, and the distances below them.
    fn draw(&self, svg: &mut String, [left, top]: [usize; 2]) -> std::fmt::Result {
        let (width, height) = (self.columns() * CELL, ROWS * CELL);
        writeln!(
            svg,
            "<path d=\"M{left} {top}h{width}v{height}h-{width}z\" fill=\"#d9d9d9\"/>"
        )?;
        for (level, colour) in COLOURS.into_iter().enumerate() {
            let mut path = String::new();
            for (row, cells) in self.cells.iter().enumerate() {
                for (column, error) in cells.iter().enumerate() {
                    if error.is_some_and(|error| level_of(error) == level) {
                        let (x, y) = (left + column * CELL, top + (ROWS - 1 - row) * CELL);
                        write!(path, "M{x} {y}h{CELL}v{CELL}h-{CELL}z")?;
                    }
                }
            }
            if !path.is_empty() {
                writeln!(svg, "<path d=\"{path}\" fill=\"{colour}\"/>")?;
            }
        }
        for column in (0..=self.columns()).step_by(2) {
            let power = NEAREST + column as i32;
            ten(
                svg,
                [left + column * CELL, top + height + 12],
                "middle",
                power,
            )?;
        }
        let middle = "text-anchor=\"middle\"";
        let label = format!("distance, m ({})", self.name);
        text(svg, [left + width / 2, top + height + 25], middle, &label)
    }
}

/// The place of an error among the levels.
fn level_of(error: f64) -> usize {
    LEVELS.iter().take_while(|level| error > **level).count()
}

/// The sizes at the left of a panel.
fn axes(svg: &mut String, [left, top]: [usize; 2]) -> std::fmt::Result {
    let all = (SIZES[1] / SIZES[0]).log10();
    for power in -2..=1 {
        let share = (f64::from(power) - SIZES[0].log10()) / all;
        let height = ((1.0 - share) * (ROWS * CELL) as f64).round() as usize;
        ten(svg, [left + 35, top + 38 + height], "end", power)?;
    }
    let [x, y] = [left + 10, top + 34 + ROWS * CELL / 2];
    let turned = format!("text-anchor=\"middle\" transform=\"rotate(-90 {x} {y})\"");
    text(svg, [x, y], &turned, "size, m")
}

/// What the colours mean.
fn legend(svg: &mut String, [left, top]: [usize; 2]) -> std::fmt::Result {
    let left = left + 38;
    let lines = [
        "Error in units of ε (distance + size·K)",
        "the largest of each cell; K: condition of the shape",
    ];
    text(svg, [left - 34, top + 14], "font-weight=\"bold\"", lines[0])?;
    text(svg, [left - 34, top + 27], "", lines[1])?;
    for (level, colour) in COLOURS.into_iter().enumerate() {
        let y = top + 36 + level * 15;
        writeln!(
            svg,
            "<path d=\"M{left} {y}h26v12h-26z\" fill=\"{colour}\" stroke=\"#888\"/>"
        )?;
        let label = match LEVELS.get(level) {
            Some(8.0) => "up to 8, the limit".to_owned(),
            Some(64.0) => "up to 64, the limit for 100 rotations".to_owned(),
            Some(most) => format!("up to {most}"),
            None => format!("more than {}", LEVELS[level - 1]),
        };
        text(svg, [left + 34, y + 10], "", &label)?;
    }
    let y = top + 36 + COLOURS.len() * 15;
    writeln!(
        svg,
        "<path d=\"M{left} {y}h26v12h-26z\" fill=\"#d9d9d9\" stroke=\"#888\"/>"
    )?;
    text(
        svg,
        [left + 34, y + 10],
        "",
        "no size that f32 resolves so far away",
    )
}

/// A power of ten.
fn ten(svg: &mut String, [x, y]: [usize; 2], anchor: &str, power: i32) -> std::fmt::Result {
    writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">10<tspan dy=\"-4\" \
         font-size=\"8\">{power}</tspan></text>"
    )
}

fn text(svg: &mut String, [x, y]: [usize; 2], style: &str, text: &str) -> std::fmt::Result {
    writeln!(svg, "<text x=\"{x}\" y=\"{y}\" {style}>{text}</text>")
}
