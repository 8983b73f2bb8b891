//! Mutual information.

use ga_runtime::batch::{Batch, Work};

use crate::plane::{PlaneError, PlaneView, same_size};

/// What the levels of two pictures say about each other, from the histogram of the pairs of levels
/// at the same places.
///
/// With p(i, j) the share of pixels that have the level i in the first picture and j in the second,
/// and p(i) = Σⱼ p(i, j), the entropies are H(A) = −Σᵢ p(i) log₂ p(i) and
/// H(A, B) = −Σᵢⱼ p(i, j) log₂ p(i, j), in bits, and the mutual information is
/// I(A; B) = H(A) + H(B) − H(A, B) (C. E. Shannon, "A mathematical theory of communication",
/// 1948).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Information {
    /// The entropy H(A) of the first picture, in bits: 0 when all its pixels are equal, 8 when all
    /// levels are equally frequent.
    pub first_bits: f64,
    /// The entropy H(B) of the second picture, in bits.
    pub second_bits: f64,
    /// The entropy H(A, B) of the pairs, in bits.
    pub joint_bits: f64,
}

impl Information {
    /// The mutual information I(A; B) in bits: 0 when the levels are independent, H(A) when the
    /// pictures are equal.
    #[must_use]
    pub fn mutual_bits(&self) -> f64 {
        // The difference may be negative by rounding.
        (self.first_bits + self.second_bits - self.joint_bits).max(0.0)
    }
}

/// The mutual information of pictures with 256 levels. Its tables are allocated once, for any
/// number of pairs of pictures.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::quality::MutualInformation;
///
/// let a = Plane::from_fn(64, 64, |column, _| (column % 4) as u8);
/// let b = Plane::from_fn(64, 64, |_, row| (row % 8) as u8);
/// let mut information = MutualInformation::new();
/// assert_eq!(information.compare(&a, &a)?.mutual_bits(), 2.0);
/// assert_eq!(information.compare(&a, &b)?.joint_bits, 5.0);
/// assert_eq!(information.compare(&a, &b)?.mutual_bits(), 0.0);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct MutualInformation {
    /// How often each pair of levels occurs: at the index 256 i + j. Pixels beside each other are
    /// counted in different tables, since they are often equal, and a number cannot be incremented
    /// again before the increment before has reached the memory.
    tables: Vec<[u32; PAIRS]>,
    /// n log₂ n for small n.
    terms: Vec<f64>,
}

const LEVELS: usize = 256;

const PAIRS: usize = LEVELS * LEVELS;

const TABLES: usize = 4;

/// Larger numbers are so rare that their logarithms are computed.
const TERMS: usize = 1 << 12;

/// Pixels whose indices are computed at once.
const PIECE: usize = 256;

impl Default for MutualInformation {
    fn default() -> Self {
        Self::new()
    }
}

impl MutualInformation {
    /// Allocates the tables, a mebibyte.
    #[must_use]
    pub fn new() -> Self {
        Self {
            tables: vec![[0; PAIRS]; TABLES],
            terms: (0..TERMS as u64).map(term).collect(),
        }
    }

    /// Entropies and mutual information of two pictures.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when there are no
    /// pixels.
    pub fn compare<'a>(
        &mut self,
        a: impl Into<PlaneView<'a, u8>>,
        b: impl Into<PlaneView<'a, u8>>,
    ) -> Result<Information, PlaneError> {
        let (a, b) = (a.into(), b.into());
        same_size(a, b)?;
        if a.is_empty() {
            return Err(PlaneError::TooSmall {
                width: a.width(),
                height: a.height(),
                least: 1,
            });
        }
        for table in &mut self.tables {
            table.fill(0);
        }
        Batch::new().run(Counting {
            a,
            b,
            tables: &mut self.tables,
        });
        let mut sums = Sums::default();
        Batch::new().run(Summing {
            tables: &self.tables,
            terms: &self.terms,
            sums: &mut sums,
        });
        let pixels = (a.width() * a.height()) as f64;
        // −Σ p log₂ p = log₂ N − (Σ n log₂ n) / N for p = n / N.
        let entropy = |sum: f64| (pixels.log2() - sum / pixels).max(0.0);
        Ok(Information {
            first_bits: entropy(sums.first),
            second_bits: entropy(sums.second),
            joint_bits: entropy(sums.joint),
        })
    }
}

/// The mutual information in bits of two pictures; [`MutualInformation`] for more than two.
///
/// # Errors
///
/// As [`MutualInformation::compare`].
pub fn mutual_information<'a>(
    a: impl Into<PlaneView<'a, u8>>,
    b: impl Into<PlaneView<'a, u8>>,
) -> Result<f64, PlaneError> {
    Ok(MutualInformation::new().compare(a, b)?.mutual_bits())
}

/// n log₂ n.
fn term(n: u64) -> f64 {
    if n == 0 {
        return 0.0;
    }
    let n = n as f64;
    n * n.log2()
}

struct Counting<'a, 't> {
    a: PlaneView<'a, u8>,
    b: PlaneView<'a, u8>,
    tables: &'t mut [[u32; PAIRS]],
}

impl Work for Counting<'_, '_> {
    #[inline(always)]
    fn run(self) {
        // No index of 16 bits is out of the range of a table.
        let Some([first, second, third, fourth]) = self.tables.first_chunk_mut::<TABLES>() else {
            return;
        };
        let mut indices = [0u16; PIECE];
        for (a, b) in self.a.rows().zip(self.b.rows()) {
            for (a, b) in a.chunks(PIECE).zip(b.chunks(PIECE)) {
                for ((index, a), b) in indices.iter_mut().zip(a).zip(b) {
                    *index = u16::from(*a) << 8 | u16::from(*b);
                }
                let (fours, rest) = indices[..a.len()].as_chunks::<TABLES>();
                for [i, j, k, l] in fours {
                    first[usize::from(*i)] += 1;
                    second[usize::from(*j)] += 1;
                    third[usize::from(*k)] += 1;
                    fourth[usize::from(*l)] += 1;
                }
                for index in rest {
                    first[usize::from(*index)] += 1;
                }
            }
        }
    }
}

/// Sums of n log₂ n over the levels of each picture, and over the pairs.
#[derive(Default)]
struct Sums {
    first: f64,
    second: f64,
    joint: f64,
}

struct Summing<'a> {
    tables: &'a [[u32; PAIRS]],
    terms: &'a [f64],
    sums: &'a mut Sums,
}

impl Work for Summing<'_> {
    #[inline(always)]
    fn run(self) {
        let term = |n: u64| match self.terms.get(n as usize) {
            Some(term) => *term,
            None => self::term(n),
        };
        let mut columns = [0u64; LEVELS];
        let mut counts = [0u64; LEVELS];
        for level in 0..LEVELS {
            counts.fill(0);
            for table in self.tables {
                let row = &table[level * LEVELS..][..LEVELS];
                for (count, n) in counts.iter_mut().zip(row) {
                    *count += u64::from(*n);
                }
            }
            let row: u64 = counts.iter().sum();
            if row == 0 {
                continue;
            }
            self.sums.first += term(row);
            self.sums.joint += counts.iter().map(|n| term(*n)).sum::<f64>();
            for (column, n) in columns.iter_mut().zip(&counts) {
                *column += n;
            }
        }
        self.sums.second = columns.iter().map(|n| term(*n)).sum();
    }
}
