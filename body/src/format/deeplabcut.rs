//! Joints in the format of DeepLabCut, CSV, a file for each view.
//!
//! Three or four rows say what the columns are, and each row below is a frame:
//!
//! ```text
//! scorer,DLC,DLC,DLC,DLC,DLC,DLC
//! individuals,anna,anna,anna,ben,ben,ben
//! bodyparts,nose,nose,nose,nose,nose,nose
//! coords,x,y,likelihood,x,y,likelihood
//! 0,310.5,82,0.99,500,90,0.8
//! ```
//!
//! The row `individuals` is only there for several, and each of them is a person, whether a frame
//! shows it or not. Joints have the names of `bodyparts`, positions are in pixels, and the
//! likelihood is the confidence; without such a column, as in labelled data, it is 1. Joints with
//! empty cells were not found. The last of the columns before the joints says which frame it is: a
//! number, or a name, of which the last number that differs counts.
//!
//! ```
//! use ga_body::format::deeplabcut;
//!
//! let text = "scorer,S,S,S\nbodyparts,nose,nose,nose\ncoords,x,y,likelihood\n0,310.5,82,0.9\n";
//! let people = deeplabcut::decode(text.as_bytes(), None)?;
//! assert_eq!(people.joints, ["nose"]);
//! let nose = people.frames[0].people[0].joints[0].ok_or("no nose")?;
//! assert_eq!((nose.position, nose.confidence), ([310.5, 82.0], 0.9));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::collections::BTreeSet;

use ga_files::table::{Table, TableError};

use super::detections::{Keypoints, Picture};
use super::{Detections, FrameKey, JointsError, Model, keys};

/// The first cell of a file.
pub(super) const FIRST: &str = "scorer";

/// What the columns of a joint are called.
const COORDINATES: [&str; 3] = ["x", "y", "likelihood"];

/// Where the table has a joint of a person.
struct Place {
    person: usize,
    joint: usize,
    /// Those of [`COORDINATES`]; that of the likelihood may be missing.
    columns: [Option<usize>; 3],
}

/// What the rows above the frames say.
#[derive(Default)]
struct Header {
    /// How many columns there are before the joints.
    index: usize,
    /// How many rows there are between the first one and the frames.
    rows: usize,
    people: Vec<String>,
    joints: Vec<String>,
    places: Vec<Place>,
}

/// Reads the joints of a view. They have the names of the model where one is given, in the order of
/// the columns.
///
/// # Errors
/// [`JointsError`] for text that is not such a table, a joint without its x and y, a cell that is
/// not a number, a frame that is there twice, a number of joints that is not that of the model, and
/// where there is no frame.
pub fn decode(bytes: &[u8], model: Option<Model>) -> Result<Detections, JointsError> {
    let table = Table::with_names(bytes)?;
    let header = Header::read(&table)?;
    let rows = header.rows..table.len();
    let last = header.index - 1;
    let names: Vec<&str> = rows
        .clone()
        .map(|row| table.text(row, last).trim())
        .collect();
    let mut known = BTreeSet::new();
    if let Some(twice) = names.iter().position(|name| !known.insert(*name)) {
        let line = table.line(header.rows + twice);
        let name = names[twice].to_owned();
        return Err(JointsError::SameRow { line, name });
    }
    let numbers: Option<Vec<i64>> = names.iter().map(|name| name.parse().ok()).collect();
    let keys = match numbers {
        Some(numbers) => numbers.into_iter().map(FrameKey::Number).collect(),
        None => keys::keys(&names),
    };
    let pictures = rows.zip(keys).map(|(row, key)| {
        let people = header.people(&table, row)?;
        Ok(Picture::new(key, people))
    });
    let pictures = pictures.collect::<Result<_, JointsError>>()?;
    Detections::new(pictures, Some(header.joints), model)
}

impl Header {
    fn read(table: &Table) -> Result<Self, JointsError> {
        let first = |row: usize| table.text(row, 0).trim().to_ascii_lowercase();
        let wrong = |row: usize, wanted| JointsError::DeepLabCut {
            line: table.line(row),
            wanted,
            found: table.text(row, 0).to_owned(),
        };
        let has_individuals = first(0) == "individuals";
        let bodyparts = usize::from(has_individuals);
        let coords = bodyparts + 1;
        for (row, wanted) in [(bodyparts, "bodyparts"), (coords, "coords")] {
            if first(row) != wanted {
                return Err(wrong(row, wanted));
            }
        }
        let coordinate = |column: usize| table.text(coords, column).trim().to_ascii_lowercase();
        let width = table.width(coords);
        let is_index = |column: &usize| *column == 0 || coordinate(*column).is_empty();
        let index = (0..width).take_while(is_index).count();
        let mut header = Self {
            index,
            rows: coords + 1,
            ..Self::default()
        };
        for column in index..width {
            let person = match has_individuals {
                true => table.text(0, column).trim(),
                false => "",
            };
            let person = place_of(&mut header.people, person);
            let joint = place_of(&mut header.joints, table.text(bodyparts, column).trim());
            let found = coordinate(column);
            let which = COORDINATES.iter().position(|name| *name == found);
            let cell = which.map(|which| &mut header.place(person, joint).columns[which]);
            match cell {
                Some(cell @ None) => *cell = Some(column),
                _ => {
                    return Err(JointsError::Coordinate {
                        line: table.line(coords),
                        column: column + 1,
                        joint: header.joints[joint].clone(),
                        found,
                    });
                }
            }
        }
        let is_half = |place: &&Place| place.columns[..2].contains(&None);
        match header.places.iter().find(is_half) {
            Some(place) => Err(JointsError::NoCoordinate {
                line: table.line(coords),
                joint: header.joints[place.joint].clone(),
            }),
            None => Ok(header),
        }
    }

    /// The place of a joint of a person, which is added where it is not there.
    fn place(&mut self, person: usize, joint: usize) -> &mut Place {
        let mut places = self.places.iter();
        let known = places.position(|place| (place.person, place.joint) == (person, joint));
        let index = known.unwrap_or(self.places.len());
        if known.is_none() {
            let columns = [None; 3];
            self.places.push(Place {
                person,
                joint,
                columns,
            });
        }
        &mut self.places[index]
    }

    /// The people of a frame, all of them.
    fn people(&self, table: &Table, row: usize) -> Result<Vec<Keypoints>, JointsError> {
        let mut people = vec![vec![[0.0; 3]; self.joints.len()]; self.people.len()];
        for place in &self.places {
            // Without a likelihood a joint is certain.
            let mut numbers = [Some(1.0); 3];
            for ((number, column), what) in numbers.iter_mut().zip(place.columns).zip(COORDINATES) {
                let Some(column) = column else { continue };
                *number = table.number(row, column).map_err(|_| TableError::Number {
                    line: table.line(row),
                    column: format!("{} {what}", self.joints[place.joint]),
                    text: table.text(row, column).to_owned(),
                })?;
            }
            if let [Some(u), Some(v), Some(likelihood)] = numbers {
                people[place.person][place.joint] = [u, v, likelihood];
            }
        }
        Ok(people)
    }
}

/// The place of a name in a list, to which it is added where it is not there.
fn place_of(names: &mut Vec<String>, name: &str) -> usize {
    let found = names.iter().position(|other| other == name);
    found.unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}
