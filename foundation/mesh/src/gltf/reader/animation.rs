//! Animations: each channel with the keys of its sampler.

use super::super::problem::{Element, Problem};
use super::super::{Animation, Channel, Interpolation, Keys, Shape, json};
use super::accessor::{Accessors, Format};
use crate::FormatError;

pub(super) fn animation(
    index: usize,
    json: &json::Animation,
    accessors: &Accessors,
) -> Result<Animation, FormatError> {
    let mut channels = Vec::with_capacity(json.channels.len());
    for (number, channel) in json.channels.iter().enumerate() {
        // The path of a channel without a node belongs to an extension.
        if let Some(node) = channel.target.node {
            let element = Element::Channel {
                animation: index,
                channel: number,
            };
            let read = self::channel(node, channel, &json.samplers, accessors);
            channels.push(read.map_err(|error| error.within(element))?);
        }
    }
    Ok(Animation {
        name: json.name.clone(),
        channels,
        extras: json.extras.clone(),
    })
}

fn channel(
    node: usize,
    json: &json::Channel,
    samplers: &[json::AnimationSampler],
    accessors: &Accessors,
) -> Result<Channel, FormatError> {
    let sampler = samplers
        .get(json.sampler)
        .ok_or_else(|| FormatError::dangling("sampler", json.sampler, samplers.len()))?;
    let value = |property, value: &str| {
        let value = value.to_owned();
        FormatError::gltf(Element::File, Problem::Value { property, value })
    };
    let interpolation = match &sampler.interpolation {
        None => Interpolation::Linear,
        Some(name) => Interpolation::from_name(name).ok_or_else(|| value("interpolation", name))?,
    };
    let times = accessors.floats::<1>(sampler.input, Shape::Scalar, Format::Float)?;
    let output = sampler.output;
    let keys = match json.target.path.as_str() {
        "translation" => Keys::Translation(accessors.floats(output, Shape::Vec3, Format::Float)?),
        "rotation" => Keys::Rotation(accessors.floats(output, Shape::Vec4, Format::Normalized)?),
        "scale" => Keys::Scale(accessors.floats(output, Shape::Vec3, Format::Float)?),
        "weights" => {
            let weights = accessors.floats::<1>(output, Shape::Scalar, Format::Normalized)?;
            Keys::Weights(weights.into_iter().flatten().collect())
        }
        other => return Err(value("path", other)),
    };
    Ok(Channel {
        node,
        times: times.into_iter().flatten().collect(),
        interpolation,
        keys,
        extras: json.extras.clone(),
    })
}
