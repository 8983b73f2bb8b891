//! Recordings as BVH files.

use std::fmt::Write as _;

use super::{Bvh, Channel};

impl Bvh {
    /// The text of the file. Numbers are written so that they read back exactly.
    #[must_use]
    pub fn encode(&self) -> String {
        let mut text = "HIERARCHY\n".to_owned();
        let mut open: Vec<usize> = Vec::new();
        let close = |text: &mut String, open: &mut Vec<usize>| {
            open.pop();
            *text += &format!("{}}}\n", "\t".repeat(open.len()));
        };
        for (index, joint) in self.joints.iter().enumerate() {
            while open.last().copied() != joint.parent && !open.is_empty() {
                close(&mut text, &mut open);
            }
            let indent = "\t".repeat(open.len());
            let keyword = if joint.parent.is_none() {
                "ROOT"
            } else {
                "JOINT"
            };
            let [x, y, z] = joint.offset;
            let channels: Vec<&str> = joint.channels.iter().map(word).collect();
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{indent}{keyword} {}\n{indent}{{\n{indent}\tOFFSET {x} {y} {z}\n\
                 {indent}\tCHANNELS {} {}",
                joint.name,
                channels.len(),
                channels.join(" ")
            );
            if let Some([x, y, z]) = joint.end_site {
                let _ = writeln!(
                    text,
                    "{indent}\tEnd Site\n{indent}\t{{\n{indent}\t\tOFFSET {x} {y} {z}\n\
                     {indent}\t}}"
                );
            }
            open.push(index);
        }
        while !open.is_empty() {
            close(&mut text, &mut open);
        }
        let _ = writeln!(
            text,
            "MOTION\nFrames: {}\nFrame Time: {}",
            self.frame_count, self.frame_time
        );
        for frame in 0..self.frame_count {
            let values = self.frame(frame).unwrap_or_default().iter();
            let words: Vec<String> = values.map(f64::to_string).collect();
            text += &words.join(" ");
            text.push('\n');
        }
        text
    }
}

/// The joints in an order in which what is below a joint follows it.
pub(super) fn depth_first(parents: &[Option<usize>]) -> Vec<usize> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); parents.len()];
    let mut to_visit = Vec::new();
    for (joint, parent) in parents.iter().enumerate().rev() {
        match *parent {
            Some(parent) => children[parent].push(joint),
            None => to_visit.push(joint),
        }
    }
    let mut order = Vec::with_capacity(parents.len());
    while let Some(joint) = to_visit.pop() {
        order.push(joint);
        to_visit.append(&mut children[joint]);
    }
    order
}

fn word(channel: &Channel) -> &'static str {
    match *channel {
        Channel::Position(0) => "Xposition",
        Channel::Position(1) => "Yposition",
        Channel::Position(_) => "Zposition",
        Channel::Rotation(0) => "Xrotation",
        Channel::Rotation(1) => "Yrotation",
        Channel::Rotation(_) => "Zrotation",
    }
}

/// A name that stands on one line, up to a brace.
pub(super) fn plain(name: &str) -> String {
    let is_strange = |c: char| c.is_control() || matches!(c, '{' | '}');
    let words = name.split_whitespace();
    let name = words.collect::<Vec<_>>().join(" ").replace(is_strange, "_");
    if name.is_empty() {
        "_".to_owned()
    } else {
        name
    }
}
