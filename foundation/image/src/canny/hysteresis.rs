//! Which weak edges are connected to strong ones, 64 pixels of a row at a time.

/// The columns that a word has bits for; the lowest bit is the leftmost column.
pub(super) const COLUMNS: usize = 64;

/// Two pictures of single bits: candidates, which are the pixels that may be edges, and edges.
///
/// Rows begin and end with a word of zeros, and there is a row of zeros above and below, so that
/// every pixel has eight neighbours.
#[derive(Clone, Debug, Default)]
pub(super) struct Hysteresis {
    candidates: Vec<u64>,
    edges: Vec<u64>,
    /// Words from one row to the next.
    stride: usize,
    /// Places, counted in bits, of edges whose neighbours have not been visited.
    pending: Vec<usize>,
}

impl Hysteresis {
    /// Prepares for a picture of another size; nothing is a candidate.
    pub(super) fn clear(&mut self, width: usize, height: usize) {
        self.stride = width.div_ceil(COLUMNS) + 2;
        for words in [&mut self.candidates, &mut self.edges] {
            words.clear();
            words.resize(self.stride * (height + 2), 0);
        }
    }

    /// Enters 64 pixels of a row: the candidates, and those of them that are edges by themselves.
    #[inline(always)]
    pub(super) fn set(&mut self, row: usize, word: usize, candidates: u64, strong: u64) {
        let index = (row + 1) * self.stride + 1 + word;
        self.candidates[index] = candidates;
        self.edges[index] = strong;
    }

    /// The edges of a row, 64 pixels in a word.
    #[inline(always)]
    pub(super) fn edges(&self, row: usize) -> &[u64] {
        &self.edges[(row + 1) * self.stride + 1..][..self.stride - 2]
    }

    /// Makes edges of the candidates of a row that are connected to edges of the row above, by way
    /// of candidates of this row.
    #[inline(always)]
    pub(super) fn grow_down(&mut self, row: usize) {
        let (above, here) = self.edges.split_at_mut((row + 1) * self.stride);
        let candidates = &self.candidates[(row + 1) * self.stride..][..self.stride];
        let above = &above[row * self.stride..];
        grow(candidates, above, &mut here[..self.stride]);
    }

    /// Makes edges of the candidates that are connected to edges, when the edges have grown down
    /// in all rows. They grow up in all rows, which leaves few; these are visited one by one.
    #[inline(always)]
    pub(super) fn finish(&mut self) {
        let height = self.edges.len() / self.stride - 2;
        for row in (0..height).rev() {
            let (here, below) = self.edges.split_at_mut((row + 2) * self.stride);
            let candidates = &self.candidates[(row + 1) * self.stride..][..self.stride];
            let here = &mut here[(row + 1) * self.stride..];
            grow(candidates, &below[..self.stride], here);
        }
        for row in 0..height {
            self.collect(row);
        }
        self.visit();
    }

    /// Makes edges of the candidates of a row that are beside edges of the row above, and notes
    /// their places.
    #[inline(always)]
    fn collect(&mut self, row: usize) {
        let start = (row + 1) * self.stride;
        for word in start + 1..start + self.stride - 1 {
            let above = word - self.stride;
            let beside = widened([above - 1, above, above + 1].map(|k| self.edges[k]));
            let mut found = self.candidates[word] & !self.edges[word] & beside;
            self.edges[word] |= found;
            while found != 0 {
                self.pending
                    .push(word * COLUMNS + found.trailing_zeros() as usize);
                found &= found - 1;
            }
        }
    }

    /// Makes edges of the candidates that are connected to edges at the places noted.
    fn visit(&mut self) {
        let stride = self.stride * COLUMNS;
        while let Some(place) = self.pending.pop() {
            for row in [place - stride, place, place + stride] {
                for neighbour in row - 1..=row + 1 {
                    let (word, bit) = (neighbour / COLUMNS, 1 << (neighbour % COLUMNS));
                    if self.candidates[word] & !self.edges[word] & bit != 0 {
                        self.edges[word] |= bit;
                        self.pending.push(neighbour);
                    }
                }
            }
        }
    }
}

/// Makes edges of the candidates of a row that are connected to edges of the row beside it, or of
/// the row itself, by way of candidates of the row.
#[inline(always)]
fn grow(candidates: &[u64], beside: &[u64], edges: &mut [u64]) {
    let last = edges.len() - 1;
    let mut carry = false;
    for word in 1..last {
        let run = candidates[word];
        let near = widened([beside[word - 1], beside[word], beside[word + 1]]);
        let seeds = edges[word] | (near & run);
        // The carry of a sum runs through the candidates from a seed on, and changes them.
        let (sum, over) = run.overflowing_add(seeds);
        let (sum, over_again) = sum.overflowing_add(u64::from(carry));
        carry = over | over_again;
        edges[word] = ((sum ^ run) | seeds) & run;
    }
    for word in (1..last).rev() {
        let run = candidates[word];
        let after = edges[word + 1] << (COLUMNS - 1) & run;
        edges[word] = filled_down(edges[word] | after, run);
    }
}

/// The middle word of three with its bits and their neighbours.
#[inline(always)]
fn widened([before, word, after]: [u64; 3]) -> u64 {
    let left = word << 1 | before >> (COLUMNS - 1);
    let right = word >> 1 | after << (COLUMNS - 1);
    word | left | right
}

/// The bits of a word, and those of `run` that lie below them without a gap.
#[inline(always)]
fn filled_down(bits: u64, run: u64) -> u64 {
    let (mut bits, mut run) = (bits, run);
    let mut distance = 1;
    while distance < COLUMNS {
        bits |= run & (bits >> distance);
        run &= run >> distance;
        distance *= 2;
    }
    bits
}
