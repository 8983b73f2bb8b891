//! Disparities for the pixels that have none, from the row.

use super::super::winner::UNKNOWN;
use super::over_rows;

/// Gives unknown disparities the lower one of the nearest known ones to the left and to the right:
/// what only one view shows lies behind what hides it from the other. Rows without any known
/// disparity become 0.
pub(in super::super) fn fill_rows(map: &mut [u16], width: usize) {
    over_rows(map, width, |_, rows| {
        for row in rows.chunks_exact_mut(width) {
            fill_row(row);
        }
    });
}

fn fill_row(row: &mut [u16]) {
    let mut column = 0;
    while column < row.len() {
        if row[column] != UNKNOWN {
            column += 1;
            continue;
        }
        let known = |disparity: &u16| *disparity != UNKNOWN;
        let length = row[column..].iter().take_while(|d| !known(d)).count();
        let before = column.checked_sub(1).map(|c| row[c]);
        let after = row.get(column + length).copied();
        let lower = before.into_iter().chain(after).min().unwrap_or(0);
        row[column..column + length].fill(lower);
        column += length;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_take_the_background() {
        let unknown = UNKNOWN;
        let mut map = vec![unknown, 7, unknown, unknown, 5, 9, unknown, 3, 3, unknown];
        fill_rows(&mut map, 5);
        assert_eq!(map, [7, 7, 5, 5, 5, 9, 3, 3, 3, 3]);
        let mut map = vec![unknown; 4];
        fill_rows(&mut map, 4);
        assert_eq!(map, [0; 4]);
    }
}
