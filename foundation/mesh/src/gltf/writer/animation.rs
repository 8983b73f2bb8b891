//! Animations: channels, and one sampler for all channels with equal keys.

use super::super::{Animation, json};
use super::buffer::{Buffer, Use};

pub(super) fn animation(animation: &Animation, buffer: &mut Buffer) -> json::Animation {
    use super::super::Keys::{Rotation, Scale, Translation, Weights};
    let mut samplers: Vec<json::AnimationSampler> = Vec::new();
    let mut channels = Vec::with_capacity(animation.channels.len());
    for channel in &animation.channels {
        let input = buffer.bounded_floats(channel.times.as_chunks::<1>().0, Use::Other);
        let output = match &channel.keys {
            Translation(values) | Scale(values) => buffer.floats(values, Use::Other),
            Rotation(values) => buffer.floats(values, Use::Other),
            Weights(values) => buffer.floats(values.as_chunks::<1>().0, Use::Other),
        };
        let sampler = json::AnimationSampler {
            input,
            output,
            interpolation: Some(channel.interpolation.name().to_owned()),
        };
        let known = samplers.iter().position(|known| *known == sampler);
        let sampler = known.unwrap_or_else(|| {
            samplers.push(sampler);
            samplers.len() - 1
        });
        channels.push(json::Channel {
            sampler,
            target: json::Target {
                node: Some(channel.node),
                path: channel.keys.path().to_owned(),
            },
            extras: channel.extras.clone(),
        });
    }
    json::Animation {
        name: animation.name.clone(),
        channels,
        samplers,
        extras: animation.extras.clone(),
    }
}
