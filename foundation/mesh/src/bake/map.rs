//! Maps: rasters of numbers.

/// A raster with C numbers for each texel, in rows from the top of the picture, each from left to
/// right. The texel in column i and row j is the square of the texture around
/// `u = (i + ½)/width`, `v = 1 − (j + ½)/height`.
#[derive(Clone, Debug, PartialEq)]
pub struct Map<const C: usize> {
    /// How many texels a row has.
    pub width: u32,
    /// How many rows there are.
    pub height: u32,
    /// The texels, row by row.
    pub texels: Vec<[f32; C]>,
}

impl<const C: usize> Map<C> {
    /// The numbers of the texel in a column and row.
    #[must_use]
    pub fn get(&self, column: u32, row: u32) -> Option<[f32; C]> {
        let is_inside = column < self.width && row < self.height;
        let index = row as usize * self.width as usize + column as usize;
        is_inside.then(|| self.texels[index])
    }
}

/// For texels around the covered ones, up to a number of steps to one of the eight neighbours, the
/// covered texel from which they are copied: `[target, source]`.
pub(super) fn dilation(size: u32, covered: &[u32], steps: u32) -> Vec<[u32; 2]> {
    const NONE: u32 = u32::MAX;
    let side = i64::from(size);
    let mut source = vec![NONE; size as usize * size as usize];
    for &texel in covered {
        source[texel as usize] = texel;
    }
    let mut copies = Vec::new();
    let mut front = covered.to_vec();
    for _ in 0..steps {
        let mut next = Vec::new();
        // Neighbours across a side come before those across a corner.
        for neighbours in [
            [(0, -1), (-1, 0), (1, 0), (0, 1)],
            [(-1, -1), (1, -1), (-1, 1), (1, 1)],
        ] {
            for &texel in &front {
                let (column, row) = (i64::from(texel) % side, i64::from(texel) / side);
                for (right, down) in neighbours {
                    let (column, row) = (column + right, row + down);
                    if !(0..side).contains(&column) || !(0..side).contains(&row) {
                        continue;
                    }
                    let neighbour = (row * side + column) as usize;
                    if source[neighbour] == NONE {
                        source[neighbour] = source[texel as usize];
                        copies.push([neighbour as u32, source[texel as usize]]);
                        next.push(neighbour as u32);
                    }
                }
            }
        }
        front = next;
    }
    copies
}
