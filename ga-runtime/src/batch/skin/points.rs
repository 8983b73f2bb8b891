//! A skin as data: points at rest in chunks.

use alloc::vec::Vec;
use core::ops::Range;

use crate::batch::skin::Bucket;

/// Points at rest and their influences, prepared for many frames.
#[derive(Clone, Debug)]
pub struct Skin<S> {
    pub(super) joints: usize,
    pub(super) points: usize,
    pub(super) has_normals: bool,
    pub(super) has_tangents: bool,
    pub(super) chunks: Vec<Chunk<S>>,
    /// The pairs of the heaviest influence of a point and another one.
    pub(super) pairs: Vec<[u32; 2]>,
}

/// A part of a [`Skin`]: consecutive points.
#[derive(Clone, Debug)]
pub struct Chunk<S> {
    pub(super) first: usize,
    pub(super) len: usize,
    pub(super) joints: usize,
    pub(super) pairs: usize,
    pub(super) buckets: Vec<Bucket<S>>,
}

impl<S> Chunk<S> {
    /// The indices of its points.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.len
    }
}

impl<S> Skin<S> {
    /// The number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points
    }

    /// Whether there are no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points == 0
    }

    /// The number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// Whether it has normals.
    #[must_use]
    pub fn has_normals(&self) -> bool {
        self.has_normals
    }

    /// Whether it has tangents.
    #[must_use]
    pub fn has_tangents(&self) -> bool {
        self.has_tangents
    }

    /// Its parts, in the order of the points.
    #[must_use]
    pub fn chunks(&self) -> &[Chunk<S>] {
        &self.chunks
    }
}
