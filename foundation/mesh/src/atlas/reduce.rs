//! Joining charts where there are too many.

use rustc_hash::{FxHashMap, FxHashSet};

use super::flatten::{self, Flattened};
use super::surface::{NONE, Surface};

/// The L2 stretch that a joined chart may have, from the first round to the last.
const STRETCHES: [f64; 4] = [1.1, 1.3, 1.7, 3.0];

/// Joins the smallest charts with neighbours until there are at most `most`, or none can be joined.
pub(super) fn reduce(surface: &Surface, charts: Vec<Flattened>, most: usize) -> Vec<Flattened> {
    if charts.len() <= most {
        return charts;
    }
    let mut charts: Vec<Option<Flattened>> = charts.into_iter().map(Some).collect();
    let mut chart_of = vec![NONE; surface.len()];
    for (index, chart) in charts.iter().enumerate() {
        for &face in chart.iter().flat_map(|chart| &chart.chart.faces) {
            chart_of[face as usize] = index as u32;
        }
    }
    let mut count = charts.len();
    for stretch in STRETCHES {
        let mut refused = FxHashSet::default();
        loop {
            let mut order: Vec<(f64, u32)> = (0..)
                .zip(&charts)
                .filter_map(|(index, chart)| Some((chart.as_ref()?.distortion.area, index)))
                .collect();
            order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let mut changed = false;
            for (_, chart) in order {
                if count <= most {
                    return charts.into_iter().flatten().collect();
                }
                if charts[chart as usize].is_none() {
                    continue;
                }
                for beside in neighbours(surface, &charts, &chart_of, chart) {
                    if refused.contains(&(chart, beside)) {
                        continue;
                    }
                    let faces = |index: u32| {
                        let chart = charts[index as usize].as_ref();
                        chart.map_or(&[][..], |chart| &chart.chart.faces)
                    };
                    let union = [faces(chart), faces(beside)].concat();
                    let Ok(joined) = flatten::whole(surface, union, stretch) else {
                        refused.insert((chart, beside));
                        continue;
                    };
                    for &face in faces(chart) {
                        chart_of[face as usize] = beside;
                    }
                    charts[chart as usize] = None;
                    charts[beside as usize] = Some(joined);
                    refused.retain(|pair| ![pair.0, pair.1].contains(&beside));
                    count -= 1;
                    changed = true;
                    break;
                }
            }
            if !changed {
                break;
            }
        }
    }
    charts.into_iter().flatten().collect()
}

/// The charts beside one, that with the longest common border first.
fn neighbours(
    surface: &Surface,
    charts: &[Option<Flattened>],
    chart_of: &[u32],
    chart: u32,
) -> Vec<u32> {
    let mut borders: FxHashMap<u32, f64> = FxHashMap::default();
    for &face in charts[chart as usize]
        .iter()
        .flat_map(|chart| &chart.chart.faces)
    {
        for side in 3 * face..3 * face + 3 {
            let other = surface.across[side as usize];
            if other != NONE && chart_of[other as usize / 3] != chart {
                let [a, b] = surface.side(side);
                *borders.entry(chart_of[other as usize / 3]).or_default() += a.distance(b);
            }
        }
    }
    let mut sorted: Vec<(u32, f64)> = borders.into_iter().collect();
    sorted.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    sorted.into_iter().map(|(beside, _)| beside).collect()
}
