//! Animations: times that rise, and a value for each.

use std::collections::HashSet;

use super::super::problem::{Element, Problem};
use super::super::{Animation, Channel, Document, Keys};
use super::check::{Checked, count, exists, fault, finite, targets_of};

pub(super) fn animation(index: usize, animation: &Animation, document: &Document) -> Checked {
    let mut seen = HashSet::new();
    for (number, channel) in animation.channels.iter().enumerate() {
        let element = || Element::Channel {
            animation: index,
            channel: number,
        };
        self::channel(channel, document).map_err(|error| error.within(element()))?;
        if !seen.insert((channel.node, channel.keys.path())) {
            let problem = Problem::Duplicate {
                what: "a channel for this property of node",
                index: channel.node,
            };
            return fault(element(), problem);
        }
    }
    Ok(())
}

fn channel(channel: &Channel, document: &Document) -> Checked {
    exists("node", channel.node, document.nodes.len())?;
    if channel.times.is_empty() {
        return fault(Element::File, Problem::Missing("keys"));
    }
    let mut before = None;
    for (key, &seconds) in channel.times.iter().enumerate() {
        let rises = before.is_none_or(|before| seconds > before);
        if !(seconds >= 0.0 && seconds.is_finite() && rises) {
            return fault(Element::File, Problem::Time { key, seconds });
        }
        before = Some(seconds);
    }
    let (values, per_key) = match &channel.keys {
        Keys::Translation(values) | Keys::Scale(values) => (values.len(), 1),
        Keys::Rotation(values) => (values.len(), 1),
        Keys::Weights(values) => {
            let mesh = document.nodes[channel.node].mesh;
            let targets = mesh.map_or(0, |mesh| targets_of(document, mesh));
            if targets == 0 {
                let what = "morph targets for its weights";
                return fault(Element::File, Problem::Missing(what));
            }
            (values.len(), targets)
        }
    };
    let expected = channel.times.len() * channel.interpolation.values_per_key() * per_key;
    count("values of keys", expected, values)?;
    finite(channel.keys.numbers().as_chunks::<1>().0)
}
