//! The order in which pieces are painted.

use super::cut::meeting_plane;
use super::piece::{Piece, Surface, mean};
use crate::camera::{Camera, Pixel};
use crate::picture::Picture;
use crate::plane::Plane;

impl Picture {
    /// Sorts so that each piece comes after those that it hides; where these relations form a
    /// cycle, by depth.
    pub(super) fn sorted(&self, pieces: Vec<Piece>, camera: &Camera) -> Vec<Piece> {
        let bounds: Vec<[Pixel; 2]> = pieces.iter().map(Piece::bounds).collect();
        let overlap = |a: usize, b: usize| {
            (0..2).all(|k| bounds[a][0][k] <= bounds[b][1][k] && bounds[b][0][k] <= bounds[a][1][k])
        };
        // For each piece, how many others must still come before it, and which come after it.
        let mut before = vec![0; pieces.len()];
        let mut after = vec![Vec::new(); pieces.len()];
        for a in 0..pieces.len() {
            for b in a + 1..pieces.len() {
                if !overlap(a, b) {
                    continue;
                }
                if let Some(hides) = self.hides(&pieces[a], &pieces[b], camera) {
                    let (first, second) = if hides { (b, a) } else { (a, b) };
                    before[second] += 1;
                    after[first].push(second);
                }
            }
        }
        let mut rest: Vec<usize> = (0..pieces.len()).collect();
        rest.sort_by(|&a, &b| pieces[a].depth.total_cmp(&pieces[b].depth));
        let mut order = Vec::new();
        while !rest.is_empty() {
            let next = rest
                .iter()
                .position(|&piece| before[piece] == 0)
                .unwrap_or(0);
            let piece = rest.remove(next);
            for &later in &after[piece] {
                before[later] -= 1;
            }
            order.push(piece);
        }
        let mut pieces: Vec<Option<Piece>> = pieces.into_iter().map(Some).collect();
        order
            .into_iter()
            .filter_map(|index| pieces[index].take())
            .collect()
    }

    /// Whether the first piece hides the second where they overlap; `None` where neither does.
    fn hides(&self, a: &Piece, b: &Piece, camera: &Camera) -> Option<bool> {
        match (a.surface, b.surface) {
            (Surface::Patch(i), Surface::Patch(j)) if i != j => {
                let plane = self.plane_of_patch(j);
                let height = plane.height(mean(&a.polygon));
                (height.abs() > 1e-9).then(|| (height > 0.0) == camera.is_above(plane))
            }
            (Surface::Ball(i), Surface::Patch(j)) => Some(self.ball_hides_patch(i, a, j, camera)),
            (Surface::Patch(i), Surface::Ball(j)) => Some(!self.ball_hides_patch(j, b, i, camera)),
            (Surface::Ball(i), Surface::Ball(j)) if i != j => {
                Some(self.ball_hides_ball([i, j], [a, b], camera))
            }
            _ => None,
        }
    }

    fn ball_hides_patch(&self, ball: usize, piece: &Piece, patch: usize, camera: &Camera) -> bool {
        let plane = self.plane_of_patch(patch);
        let side = piece
            .side_of(Surface::Patch(patch))
            .unwrap_or_else(|| plane.height(self.balls[ball].centre) > 0.0);
        side == camera.is_above(plane)
    }

    fn ball_hides_ball(&self, [i, j]: [usize; 2], pieces: [&Piece; 2], camera: &Camera) -> bool {
        let [a, b] = [&self.balls[i], &self.balls[j]];
        let way = b.centre - a.centre;
        let apart = way.length();
        if apart <= (a.radius - b.radius).abs() {
            // The front of the outer ball is in front of the inner ball.
            return a.radius > b.radius;
        }
        if meeting_plane(a, b).is_none() {
            // The plane half way between the surfaces.
            let normal = way * apart.recip();
            let gap = apart - a.radius - b.radius;
            let distance = normal.dot(a.centre) + a.radius + 0.5 * gap;
            return !camera.is_above(Plane { normal, distance });
        }
        // The positive side of the plane as seen from a is that of b.
        let within = |piece: &Piece, other| piece.side_of(Surface::Ball(other)).unwrap_or(false);
        match (within(pieces[0], j), within(pieces[1], i)) {
            (false, false) => meeting_plane(a, b).is_none_or(|plane| !camera.is_above(plane)),
            // The part within the other ball is behind its surface.
            (within_b, _) => !within_b,
        }
    }
}
