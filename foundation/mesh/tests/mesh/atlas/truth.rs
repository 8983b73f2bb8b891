//! The figures of an atlas by definition, without the code that makes it.

use ga_mesh::atlas::Atlas;

use super::shapes::Shape;

type Flat = [f64; 2];

pub(super) struct Figures {
    pub(super) charts: usize,
    pub(super) utilisation: f64,
    pub(super) stretch_l2: f64,
    pub(super) flipped: usize,
    /// Texels whose centre lies inside two triangles.
    pub(super) double: usize,
    /// Texels within the margin of two charts.
    pub(super) contested: usize,
    /// Texels that a triangle touches outside of the square.
    pub(super) outside: usize,
}

pub(super) fn figures(shape: &Shape, atlas: &Atlas, size: usize, margin: usize) -> Figures {
    let mut inside = vec![0u8; size * size];
    let mut owner = vec![u32::MAX; size * size];
    let mut contested = vec![false; size * size];
    let (mut area, mut flat_area, mut stretched) = (0.0, 0.0, 0.0);
    let (mut flipped, mut outside) = (0, 0);
    let unit = shape
        .positions
        .iter()
        .flatten()
        .fold(0.0_f64, |a, x| a.max(x.abs()));
    for (face, triangle) in shape.triangles.iter().enumerate() {
        let corners = triangle.map(|v| shape.positions[v as usize].map(|x| x / unit));
        let flat = atlas.coordinates[face].map(|uv| uv.map(|x| x * size as f64));
        if flat[0] == flat[1] && flat[1] == flat[2] {
            assert!(
                height(corners) < 1e-8,
                "face {face} of {} has no image",
                shape.name
            );
            continue;
        }
        let (triangle_area, signed, squared) = stretch(corners, flat);
        area += triangle_area;
        flat_area += signed;
        stretched += triangle_area * squared;
        flipped += usize::from(signed <= 0.0);
        let margin = margin as f64;
        let range = |axis: usize| {
            let low = flat.iter().fold(f64::INFINITY, |a, p| a.min(p[axis]));
            let high = flat.iter().fold(f64::NEG_INFINITY, |a, p| a.max(p[axis]));
            (low - margin).floor() as i64..=(high + margin).floor() as i64
        };
        for row in range(1) {
            for column in range(0) {
                let centre = [column as f64 + 0.5, row as f64 + 0.5];
                if !touches(flat, centre, 0.5 + margin) {
                    continue;
                }
                let (Ok(c), Ok(r)) = (usize::try_from(column), usize::try_from(row)) else {
                    outside += 1;
                    continue;
                };
                if c >= size || r >= size {
                    outside += 1;
                    continue;
                }
                let texel = r * size + c;
                inside[texel] += u8::from(contains(flat, centre));
                let chart = atlas.charts[face];
                contested[texel] |= owner[texel] != u32::MAX && owner[texel] != chart;
                owner[texel] = chart;
            }
        }
    }
    let mut charts = atlas.charts.clone();
    charts.sort_unstable();
    charts.dedup();
    Figures {
        charts: charts.len(),
        utilisation: inside.iter().filter(|&&count| count > 0).count() as f64
            / (size * size) as f64,
        stretch_l2: (stretched / area * (flat_area / area)).sqrt(),
        flipped,
        double: inside.iter().filter(|&&count| count > 1).count(),
        contested: contested.iter().filter(|&&contested| contested).count(),
        outside,
    }
}

/// The area of a triangle, the signed area of its image, and half the trace of the metric that the
/// surface induces on the texture.
fn stretch(corners: [[f64; 3]; 3], flat: [Flat; 3]) -> (f64, f64, f64) {
    let side = |a: usize, b: usize| -> [f64; 3] {
        std::array::from_fn(|axis| corners[b][axis] - corners[a][axis])
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (e, f) = (side(0, 1), side(0, 2));
    let (ee, ef, ff) = (dot(e, e), dot(e, f), dot(f, f));
    let (a, b) = (difference(flat[1], flat[0]), difference(flat[2], flat[0]));
    let determinant = a[0] * b[1] - a[1] * b[0];
    // The metric in texture coordinates is D⁻ᵀ G D⁻¹ with D = [a b]; its trace is that of
    // G (DᵀD)⁻¹.
    let (aa, ab, bb) = (dot2(a, a), dot2(a, b), dot2(b, b));
    let trace = (ee * bb - 2.0 * ef * ab + ff * aa) / (determinant * determinant);
    let area = 0.5 * (ee * ff - ef * ef).max(0.0).sqrt();
    (area, 0.5 * determinant, 0.5 * trace)
}

/// The height of a triangle over its longest side, divided by that side.
fn height([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let side = |p: [f64; 3], q: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| q[k] - p[k]) };
    let square = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>();
    let (e, f) = (side(a, b), side(a, c));
    let cross: [f64; 3] =
        std::array::from_fn(|k| e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3]);
    let longest = [e, f, side(b, c)]
        .map(square)
        .into_iter()
        .fold(0.0, f64::max);
    if longest == 0.0 {
        0.0
    } else {
        square(cross).sqrt() / longest
    }
}

fn difference(a: Flat, b: Flat) -> Flat {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot2(a: Flat, b: Flat) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Whether a point is strictly inside a triangle that runs counter-clockwise.
fn contains(flat: [Flat; 3], point: Flat) -> bool {
    (0..3).all(|k| {
        let (a, b) = (flat[k], flat[(k + 1) % 3]);
        let (along, to) = (difference(b, a), difference(point, a));
        along[0] * to[1] - along[1] * to[0] > 1e-7
    })
}

/// Whether a triangle meets the open square of this centre and half side: no line through a side of
/// either separates them.
fn touches(flat: [Flat; 3], centre: Flat, half: f64) -> bool {
    let half = half - 1e-9;
    let axes = (0..3).map(|k| {
        let d = difference(flat[(k + 1) % 3], flat[k]);
        [-d[1], d[0]]
    });
    axes.chain([[1.0, 0.0], [0.0, 1.0]]).all(|axis| {
        let values = flat.map(|p| dot2(p, axis));
        let low = values.iter().fold(f64::INFINITY, |a, &x| a.min(x));
        let high = values.iter().fold(f64::NEG_INFINITY, |a, &x| a.max(x));
        let middle = dot2(centre, axis);
        let reach = half * (axis[0].abs() + axis[1].abs());
        low < middle + reach && middle - reach < high
    })
}
