//! How feet stand in a motion that is transferred.

use serde::Serialize;

use super::foot_locking::Contact;
use crate::skeleton::Skeleton;

/// A foot while it stands, over all times at which it does.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StandingFoot {
    /// The joint of the ankle in the target.
    pub joint: String,
    /// How many times it stands.
    pub contacts: usize,
    /// In how many frames it stands.
    pub standing_frames: usize,
    /// How far apart two places of the ankle are at most while it stands, in metres.
    pub slide_metres: f64,
    /// The same without foot locking.
    pub slide_free_metres: f64,
    /// How far the ankle is at most from where it should stand, in metres, since the leg is too
    /// short.
    pub short_by_metres: f64,
    /// The first frame of that contact; `None` where the leg reaches.
    pub short_in_frame: Option<usize>,
}

impl StandingFoot {
    /// The feet of contacts, which follow foot after foot, in a motion with foot locking or without
    /// it. One unit of the target is `metres_per_unit` long.
    #[must_use]
    pub fn of_contacts(
        contacts: &[Contact],
        target: &Skeleton,
        metres_per_unit: f64,
        is_locked: bool,
    ) -> Vec<Self> {
        let of_foot = contacts.chunk_by(|a, b| a.ankle == b.ankle);
        of_foot
            .filter_map(|contacts| {
                let joint = target.joints().get(contacts.first()?.ankle)?;
                let mut foot = Self {
                    joint: joint.name.clone(),
                    contacts: contacts.len(),
                    standing_frames: 0,
                    slide_metres: 0.0,
                    slide_free_metres: 0.0,
                    short_by_metres: 0.0,
                    short_in_frame: None,
                };
                for contact in contacts {
                    foot.add(contact, metres_per_unit, is_locked);
                }
                Some(foot)
            })
            .collect()
    }

    fn add(&mut self, contact: &Contact, metres_per_unit: f64, is_locked: bool) {
        let free = contact.slide_before * metres_per_unit;
        let (slide, short) = match is_locked {
            true => [contact.slide, contact.short_by]
                .map(|length| length * metres_per_unit)
                .into(),
            false => (free, 0.0),
        };
        self.standing_frames += contact.frames.end() + 1 - contact.frames.start();
        self.slide_metres = self.slide_metres.max(slide);
        self.slide_free_metres = self.slide_free_metres.max(free);
        if short > self.short_by_metres {
            self.short_by_metres = short;
            self.short_in_frame = Some(*contact.frames.start());
        }
    }

    /// The frame from which on the foot stands notably away from its place, by more than 5 mm.
    #[must_use]
    pub fn is_short_from(&self) -> Option<usize> {
        const NOTABLE: f64 = 0.005;
        let is_notable = self.short_by_metres > NOTABLE;
        self.short_in_frame.filter(|_| is_notable)
    }
}
