//! Removes from a file what nothing refers to any more.

use serde_json::{Map, Value};

use super::references::{To, are_known, compressed, visit};

/// Removes the accessors and buffer views that something referred to when the file was read and
/// nothing refers to now, with their bytes. Where an extension may have references that are not
/// known, all stay.
pub(super) fn remove(root: &mut Map<String, Value>, bytes: &mut Vec<u8>, old: &Map<String, Value>) {
    if !are_known(root) {
        return;
    }
    let was_used = Used::new(&mut old.clone());
    // Views belong to accessors, so these come first.
    for to in [To::Accessor, To::View] {
        let is_used = Used::new(root);
        let is_left_over = |index: usize| was_used.has(to, index) && !is_used.has(to, index);
        let list = match to {
            To::Accessor => "accessors",
            To::View => "bufferViews",
        };
        let count = root.get(list).and_then(Value::as_array).map_or(0, Vec::len);
        let mut left = 0;
        let numbers: Vec<Option<usize>> = (0..count)
            .map(|index| {
                let stays = !is_left_over(index);
                left += usize::from(stays);
                stays.then(|| left - 1)
            })
            .collect();
        if left == count {
            continue;
        }
        if let Some(list) = root.get_mut(list).and_then(Value::as_array_mut) {
            let mut number = numbers.iter();
            list.retain(|_| number.next().is_some_and(Option::is_some));
        }
        if left == 0 {
            root.remove(list);
        }
        visit(root, |kind, reference| {
            let number = reference.as_u64().filter(|_| kind == to);
            if let Some(&Some(number)) = number.and_then(|index| numbers.get(index as usize)) {
                *reference = number.into();
            }
        });
        if to == To::View {
            compact(root, bytes);
        }
    }
}

/// What is referred to.
struct Used {
    accessors: Vec<u64>,
    views: Vec<u64>,
}

impl Used {
    fn new(root: &mut Map<String, Value>) -> Self {
        let (mut accessors, mut views) = (Vec::new(), Vec::new());
        visit(root, |to, reference| {
            let list = match to {
                To::Accessor => &mut accessors,
                To::View => &mut views,
            };
            list.extend(reference.as_u64());
        });
        accessors.sort_unstable();
        views.sort_unstable();
        Self { accessors, views }
    }

    fn has(&self, to: To, index: usize) -> bool {
        let list = match to {
            To::Accessor => &self.accessors,
            To::View => &self.views,
        };
        list.binary_search(&(index as u64)).is_ok()
    }
}

/// Keeps the bytes of the first buffer that a view has, and moves the views to them.
fn compact(root: &mut Map<String, Value>, bytes: &mut Vec<u8>) {
    let views = root.get_mut("bufferViews").and_then(Value::as_array_mut);
    let mut views: Vec<&mut Value> = views.into_iter().flatten().collect();
    let mut parts = Vec::new();
    for view in &mut views {
        parts.extend(part(view));
        parts.extend(compressed(view).filter_map(|it| part(it)));
    }
    parts.sort_unstable();
    // Parts that overlap or touch stay beside each other.
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (start, end) in parts {
        match runs.last_mut() {
            Some((_, last)) if start <= *last => *last = end.max(*last),
            _ => runs.push((start, end)),
        }
    }
    let mut kept: Vec<u8> = Vec::new();
    let mut moved = Vec::with_capacity(runs.len());
    for &(start, end) in &runs {
        let Some(run) = bytes.get(start..end) else {
            return;
        };
        // As far from a multiple of four as before.
        while kept.len() % 4 != start % 4 {
            kept.push(0);
        }
        moved.push(kept.len());
        kept.extend_from_slice(run);
    }
    let place = |view: &mut Value| {
        let Some((start, _)) = part(view) else {
            return;
        };
        let run = runs.partition_point(|run| run.0 <= start).saturating_sub(1);
        if let (Some(&(first, _)), Some(&place)) = (runs.get(run), moved.get(run)) {
            view["byteOffset"] = (place + start - first).into();
        }
    };
    for view in views {
        compressed(view).for_each(place);
        place(view);
    }
    kept.resize(kept.len().next_multiple_of(4), 0);
    *bytes = kept;
}

/// The bytes of the first buffer that a view, or what it is decompressed from, has.
fn part(view: &Value) -> Option<(usize, usize)> {
    let number = |key: &str| view.get(key).and_then(Value::as_u64).unwrap_or(0) as usize;
    if number("buffer") != 0 {
        return None;
    }
    let start = number("byteOffset");
    Some((start, start.checked_add(number("byteLength"))?))
}
