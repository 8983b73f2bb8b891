//! The loops over tiles, which the compiler translates into vector instructions: first the sums for
//! all points of a tile, then their images.

use super::bucket::{Bucket, Motors, TILE};
use super::maps;
use super::palette::{AffinePalette, Coefficients, Columns, MotorPalette};
use super::scalar::SkinScalar;
use crate::cga3::{Direction, Motor, Point};
use crate::instruction_set::InstructionSet;
use crate::vga3::Vector;

/// The images of the points of a tile, coordinate by coordinate.
pub(super) struct Tile<S> {
    pub(super) points: [[S; TILE]; 3],
    pub(super) normals: [[S; TILE]; 3],
    pub(super) tangents: [[S; TILE]; 3],
    motors: Motors<S>,
    maps: [Columns<S>; TILE],
}

impl<S: SkinScalar> Tile<S> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = [[S::zero(); TILE]; 3];
        Self {
            points: zero,
            normals: zero,
            tangents: zero,
            motors: [[S::one(); TILE]; 8],
            maps: [Columns::default(); TILE],
        }
    }

    /// The means of affine maps, for the tile that begins at `start`.
    #[inline(always)]
    pub(super) fn by_affine_maps(
        &mut self,
        bucket: &Bucket<S>,
        start: usize,
        palette: &AffinePalette<S>,
        asked: Asked,
    ) {
        let sums = &mut self.maps;
        sum_maps(bucket, start, &palette.maps, sums);
        for (i, (sum, x)) in sums
            .iter()
            .zip(&bucket.points[start..start + TILE])
            .enumerate()
        {
            put(
                &mut self.points,
                i,
                maps::affine(sum).transform(maps::point(*x)).coordinates(),
            );
        }
        if asked.normals {
            for (i, (sum, n)) in sums
                .iter()
                .zip(&bucket.normals[start..start + TILE])
                .enumerate()
            {
                let normal = maps::normal(maps::affine(sum), maps::vector(*n));
                put(&mut self.normals, i, normal.coordinates());
            }
        }
        if asked.tangents {
            for (i, (sum, t)) in sums
                .iter()
                .zip(&bucket.tangents[start..start + TILE])
                .enumerate()
            {
                let tangent = maps::tangent(maps::affine(sum), maps::vector(*t));
                put(&mut self.tangents, i, tangent.coordinates());
            }
        }
    }

    /// The blends of motors, for the tile that begins at `start`.
    #[inline(always)]
    pub(super) fn by_motors(
        &mut self,
        set: InstructionSet,
        bucket: &Bucket<S>,
        start: usize,
        palette: &MotorPalette<S>,
        asked: Asked,
    ) {
        let motors = &mut self.motors;
        if !S::sum_motors(set, bucket, start, palette, motors) {
            sum_motors(bucket, start, palette, motors);
        }
        if palette.has_doubtful {
            blend_doubtful(bucket, start, palette, motors);
        }
        let rest = start..start + TILE;
        if palette.stretches.is_empty() {
            move_points(motors, &bucket.points[rest.clone()], &mut self.points);
            if asked.normals {
                rotate(motors, &bucket.normals[rest.clone()], &mut self.normals);
            }
            if asked.tangents {
                rotate(motors, &bucket.tangents[rest], &mut self.tangents);
            }
            return;
        }
        let sums = &mut self.maps;
        sum_maps(bucket, start, &palette.stretches, sums);
        let mut stretched = [[S::zero(); 4]; TILE];
        for ((to, sum), x) in stretched
            .iter_mut()
            .zip(&*sums)
            .zip(&bucket.points[rest.clone()])
        {
            *to = four(maps::affine(sum).transform(maps::point(*x)).coordinates());
        }
        move_points(motors, &stretched, &mut self.points);
        if asked.normals {
            for ((to, sum), n) in stretched
                .iter_mut()
                .zip(&*sums)
                .zip(&bucket.normals[rest.clone()])
            {
                *to = four(maps::normal(maps::affine(sum), maps::vector(*n)).coordinates());
            }
            rotate(motors, &stretched, &mut self.normals);
        }
        if asked.tangents {
            for ((to, sum), t) in stretched.iter_mut().zip(&*sums).zip(&bucket.tangents[rest]) {
                *to = four(maps::tangent(maps::affine(sum), maps::vector(*t)).coordinates());
            }
            rotate(motors, &stretched, &mut self.tangents);
        }
    }
}

/// Which directions are asked for besides points.
#[derive(Clone, Copy)]
pub(super) struct Asked {
    pub(super) normals: bool,
    pub(super) tangents: bool,
}

#[inline(always)]
fn put<S: Copy>(list: &mut [[S; TILE]; 3], place: usize, [x, y, z]: [S; 3]) {
    list[0][place] = x;
    list[1][place] = y;
    list[2][place] = z;
}

#[inline(always)]
fn four<S: SkinScalar>([x, y, z]: [S; 3]) -> [S; 4] {
    [x, y, z, S::zero()]
}

/// The influences of the points of a tile: the entries of one of the lists of indices, and weights.
#[inline(always)]
fn rows<'a, S, I>(
    bucket: &'a Bucket<S>,
    entries: &'a [I],
    start: usize,
) -> impl Iterator<Item = (&'a [I], &'a [S])> {
    let count = bucket.influences;
    let entries = entries[start * count..].chunks_exact(count);
    entries
        .zip(bucket.weights[start * count..].chunks_exact(count))
        .take(TILE)
}

#[inline(always)]
fn sum_maps<S: SkinScalar>(
    bucket: &Bucket<S>,
    start: usize,
    palette: &[Columns<S>],
    sums: &mut [Columns<S>; TILE],
) {
    for ((joints, weights), sum) in rows(bucket, &bucket.joints, start).zip(sums) {
        let mut total = [S::zero(); 16];
        for (joint, weight) in joints.iter().zip(weights) {
            let map = &palette[usize::from(*joint)].0;
            for (total, entry) in total.iter_mut().zip(map) {
                *total += *entry * *weight;
            }
        }
        sum.0 = total;
    }
}

#[inline(always)]
fn sum_motors<S: SkinScalar>(
    bucket: &Bucket<S>,
    start: usize,
    palette: &MotorPalette<S>,
    sums: &mut Motors<S>,
) {
    for (place, (signed, weights)) in rows(bucket, &bucket.signed, start).enumerate() {
        let mut total = [S::zero(); 8];
        for (signed, weight) in signed.iter().zip(weights) {
            let Coefficients(motor) = &palette.motors[palette.signed[*signed as usize] as usize];
            for (total, entry) in total.iter_mut().zip(motor) {
                *total += *entry * *weight;
            }
        }
        for (sums, total) in sums.iter_mut().zip(total) {
            sums[place] = total;
        }
    }
}

/// Whether a point of the tile that begins at `start` has influences that are half a turn apart.
#[inline(always)]
pub(super) fn is_doubtful<S: SkinScalar>(
    bucket: &Bucket<S>,
    start: usize,
    palette: &MotorPalette<S>,
) -> bool {
    let count = bucket.influences;
    let signed = &bucket.signed[start * count..(start + TILE) * count];
    signed
        .iter()
        .any(|signed| palette.doubtful[*signed as usize])
}

/// Replaces the sums for points with influences that are half a turn apart, whose signs depend on
/// all influences.
#[cold]
#[inline(never)]
fn blend_doubtful<S: SkinScalar>(
    bucket: &Bucket<S>,
    start: usize,
    palette: &MotorPalette<S>,
    sums: &mut Motors<S>,
) {
    for (place, (signed, weights)) in rows(bucket, &bucket.signed, start).enumerate() {
        if !signed
            .iter()
            .any(|signed| palette.doubtful[*signed as usize])
        {
            continue;
        }
        let weighted = signed.iter().zip(weights).map(|(signed, weight)| {
            let motor = palette.motors[palette.signed[*signed as usize] as usize].motor();
            (*weight, motor)
        });
        // The blend exists, since the motors are finite and the first has a weight above zero.
        let blend = Motor::blend_influences(weighted).unwrap_or_default();
        for (sums, coefficient) in sums.iter_mut().zip(Coefficients::new(blend).0) {
            sums[place] = coefficient;
        }
    }
}

/// The motor of a sum, divided by its length. What the sum has along the pseudoscalar times its
/// rotation does not move anything.
macro_rules! motor {
    ($sums:ident, $place:ident) => {{
        let [s, a, b, c, x, y, z, volume] = $sums;
        let (s, a, b, c) = (s[$place], a[$place], b[$place], c[$place]);
        let scale = (s * s + a * a + (b * b + c * c)).sqrt().recip();
        Motor::new_unchecked(
            s * scale,
            a * scale,
            b * scale,
            c * scale,
            x[$place] * scale,
            y[$place] * scale,
            z[$place] * scale,
            volume[$place] * scale,
        )
    }};
}

/// The first three coordinates of the points of a tile, each in a list of its own: together with
/// the arithmetic on motors the compiler would not vectorise the reading of fours.
#[inline(always)]
fn by_coordinate<S: SkinScalar>(rest: &[[S; 4]]) -> [[S; TILE]; 3] {
    let mut lists = [[S::zero(); TILE]; 3];
    for (place, four) in rest.iter().take(TILE).enumerate() {
        lists[0][place] = four[0];
        lists[1][place] = four[1];
        lists[2][place] = four[2];
    }
    lists
}

#[inline(always)]
fn move_points<S: SkinScalar>(sums: &Motors<S>, rest: &[[S; 4]], moved: &mut [[S; TILE]; 3]) {
    let rest = by_coordinate(rest);
    let [xs, ys, zs] = moved;
    for place in 0..TILE {
        let (x, y, z) = (rest[0][place], rest[1][place], rest[2][place]);
        let motor: Motor<S> = motor!(sums, place);
        let image = motor.transform(Point::new(x, y, z));
        xs[place] = image.e1();
        ys[place] = image.e2();
        zs[place] = image.e3();
    }
}

#[inline(always)]
fn rotate<S: SkinScalar>(sums: &Motors<S>, rest: &[[S; 4]], moved: &mut [[S; TILE]; 3]) {
    let rest = by_coordinate(rest);
    let [xs, ys, zs] = moved;
    for place in 0..TILE {
        let (x, y, z) = (rest[0][place], rest[1][place], rest[2][place]);
        let motor: Motor<S> = motor!(sums, place);
        let image = motor.transform(Direction::new(x, y, z));
        let image = Vector::from(image);
        xs[place] = image.e1;
        ys[place] = image.e2;
        zs[place] = image.e3;
    }
}
