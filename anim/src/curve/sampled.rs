//! The curves of a table, and points on them.

use serde::Serialize;

use super::channel_ends::ChannelEnds;
use super::piecewise::Curve;
use super::resample::{Distance, resample_channels, sample_channels};
use super::table::{KeyTable, KeyTableError};

/// At which times curves are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// So many times at equal steps, from the first key to the last.
    Even(usize),
    /// At the vertices of a polyline that stays within a tolerance of the curves.
    Within {
        /// The tolerance in the unit of the channels.
        tolerance: f64,
        /// The distance that it bounds; where none is given, that at equal times for one channel
        /// and the geometric one for more.
        distance: Option<Distance>,
        /// At most so many vertices.
        most: usize,
    },
}

/// Splines through the channels of a [`KeyTable`], and rows of their values.
///
/// ```
/// use ga_anim::curve::table::KeyTable;
/// use ga_anim::curve::{SampledTable, Sampling};
///
/// let tent = KeyTable::decode(b"t,x\n0,0\n1,1\n2,0\n")?;
/// let sampled = SampledTable::new(&tent, &"natural".parse()?, Sampling::Even(5))?;
/// // (3t − t³)/2 and its mirror image.
/// assert_eq!(sampled.values, [[0.0], [0.6875], [1.0], [0.6875], [0.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct SampledTable {
    /// The curve of each channel.
    #[serde(skip)]
    pub curves: Vec<Curve<f64>>,
    /// The time of each row.
    #[serde(skip)]
    pub times: Vec<f64>,
    /// The values of all channels in each row.
    #[serde(skip)]
    pub values: Vec<Vec<f64>>,
    /// How many keys the table has.
    pub keys: usize,
    /// The names of the channels.
    pub channels: Vec<String>,
    /// The conditions at the ends, without their numbers.
    pub ends: String,
    /// The time of the first key.
    pub first_time: f64,
    /// The time of the last key.
    pub last_time: f64,
    /// How many rows there are.
    pub rows: usize,
    /// The tolerance of a polyline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// The distance that it bounds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<Distance>,
    /// The proven bound of that distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_deviation: Option<f64>,
}

impl SampledTable {
    /// Draws splines through the keys of a table, and samples them.
    ///
    /// # Errors
    ///
    /// Those of [`KeyTable::splines`] and [`resample_channels`].
    pub fn new(
        table: &KeyTable,
        ends: &ChannelEnds,
        sampling: Sampling,
    ) -> Result<Self, KeyTableError> {
        let curves = table.splines(ends)?;
        let mut sampled = Self {
            times: Vec::new(),
            values: Vec::new(),
            keys: table.times.len(),
            channels: table.names[1..].to_vec(),
            ends: ends.to_string(),
            first_time: curves[0].start(),
            last_time: curves[0].end(),
            rows: 0,
            tolerance: None,
            distance: None,
            max_deviation: None,
            curves,
        };
        match sampling {
            Sampling::Even(count) => {
                sampled.times = sampled.curves[0].even_times(count);
                sampled.values = sample_channels(&sampled.curves, &sampled.times);
            }
            Sampling::Within {
                tolerance,
                distance,
                most,
            } => {
                let distance = distance.unwrap_or(match sampled.curves.len() {
                    1 => Distance::EqualTime,
                    _ => Distance::Geometric,
                });
                let found = resample_channels(&sampled.curves, tolerance, distance, most)?;
                (sampled.times, sampled.values) = (found.times, found.values);
                sampled.tolerance = Some(tolerance);
                sampled.distance = Some(distance);
                sampled.max_deviation = Some(found.max_deviation);
            }
        }
        sampled.rows = sampled.times.len();
        Ok(sampled)
    }
}
