//! Animated documents as they are drawn.

use std::path::Path;

use ga_anim::gltf::{Placement, Player};
use ga_anim::skin::Method;
use ga_mesh::gltf::{CameraElement, Document, Projection};
use ga_render::model::Model;
use ga_render::{View, Viewpoint};
use ga_runtime::vga3::Vector;

use crate::error::CharacterError;

/// A time in seconds of an animation, or the pose of the nodes alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// The animation.
    pub animation: Option<usize>,
    /// The time.
    pub seconds: f64,
}

/// The scene that a document shows, at any moment of its animations: what moves are the nodes with
/// their meshes, the vertices by their joints, and the weights of the morph targets. Pictures of
/// materials are read once.
///
/// ```
/// use ga_character::animated_scene::{AnimatedScene, Moment};
/// use ga_mesh::gltf::{Animation, Channel, Document, Interpolation, Keys, Mesh, Node, Primitive};
///
/// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let triangle = Primitive { positions: corners, ..Primitive::default() };
/// let go = Channel {
///     node: 0,
///     times: vec![0.0, 2.0],
///     interpolation: Interpolation::Linear,
///     keys: Keys::Translation(vec![[0.0; 3], [4.0, 0.0, 0.0]]),
///     extras: None,
/// };
/// let document = Document {
///     nodes: vec![Node { mesh: Some(0), ..Node::default() }],
///     meshes: vec![Mesh { primitives: vec![triangle], ..Mesh::default() }],
///     animations: vec![Animation { channels: vec![go], ..Animation::default() }],
///     ..Document::default()
/// };
/// let mut scene = AnimatedScene::new(&document, None)?;
/// let model = scene.at(Moment { animation: Some(0), seconds: 0.5 })?;
/// assert_eq!(model.bounds()[0].coordinates(), [1.0, 0.0, 0.0]);
/// # Ok::<(), ga_character::CharacterError>(())
/// ```
#[derive(Debug)]
pub struct AnimatedScene<'a> {
    player: Player<'a>,
    placement: Placement<'a>,
    /// Whether a node is in the scene that is shown.
    is_shown: Vec<bool>,
    method: Method,
    model: Model,
}

impl<'a> AnimatedScene<'a> {
    /// The default scene of a document. The files of its pictures are looked for in `folder`, or
    /// left out without one.
    ///
    /// # Errors
    ///
    /// [`CharacterError::Document`] where the document is not valid, and
    /// [`CharacterError::Texture`] for a picture that exists and cannot be read.
    pub fn new(document: &'a Document, folder: Option<&Path>) -> Result<Self, CharacterError> {
        let player = Player::new(document)?;
        let placement = Placement::new(&player)?;
        let mut is_shown = vec![false; document.nodes.len()];
        for node in document.shown_nodes() {
            is_shown[node] = true;
        }
        let placed = placement.place(&player.pose(None, 0.0)?, Method::Linear)?;
        let mesh = placement.mesh(&placed, |node| is_shown[node]);
        let model = Model::from_mesh(&mesh?, folder);
        Ok(Self {
            player,
            placement,
            is_shown,
            method: Method::Linear,
            model: model.map_err(|error| CharacterError::Texture(Box::new(error)))?,
        })
    }

    /// The same scene with vertices with several joints moved by this method in place of the linear
    /// blend, which is what glTF says.
    #[must_use]
    pub fn with_method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// The scene at a moment.
    ///
    /// # Errors
    ///
    /// [`CharacterError::Document`] for an animation that the document does not have, and where
    /// numbers go beyond double precision.
    pub fn at(&mut self, moment: Moment) -> Result<&Model, CharacterError> {
        let pose = self.player.pose(moment.animation, moment.seconds)?;
        let placed = self.placement.place(&pose, self.method)?;
        let mesh = self.placement.mesh(&placed, |node| self.is_shown[node]);
        self.model.set_shape(&mesh?);
        Ok(&self.model)
    }

    /// The view from a viewpoint of pictures with this quotient of width and height, and the least
    /// and the greatest coordinates: from a side, the scene is seen whole at all of these moments.
    ///
    /// # Errors
    ///
    /// As [`at`](Self::at), and [`CharacterError::Viewpoint`] where there is nothing to be seen.
    pub fn framing(
        &mut self,
        moments: impl IntoIterator<Item = Moment>,
        viewpoint: &Viewpoint,
        aspect: f64,
    ) -> Result<(View, [Vector<f64>; 2]), CharacterError> {
        let mut bounds: Option<[Vector<f64>; 2]> = None;
        let mut failure = None;
        // One moment after the other, so that the points of only one are in memory.
        let points = moments
            .into_iter()
            .flat_map(|moment| match self.at(moment) {
                Ok(model) => {
                    let [low, high] = bounds.unwrap_or_else(|| model.bounds());
                    bounds = ga_mesh::bounds([low, high].into_iter().chain(model.bounds()));
                    model.points().collect()
                }
                Err(error) => {
                    failure.get_or_insert(error);
                    Vec::new()
                }
            });
        let mut points = points.fuse();
        let view = viewpoint.view(&mut points, aspect);
        // A viewpoint at a place looks at no points.
        points.for_each(drop);
        if let Some(error) = failure {
            return Err(error);
        }
        let view = view.map_err(CharacterError::Viewpoint)?;
        Ok((view, bounds.unwrap_or_default()))
    }

    /// What the camera of a node sees at a moment: it looks along the negative z axis of the node,
    /// whose y axis points up.
    ///
    /// # Errors
    ///
    /// [`CharacterError::NoCamera`], [`CharacterError::ParallelProjection`], those of
    /// [`at`](Self::at), and [`CharacterError::View`] where the frame of the node has no axes.
    pub fn view(&self, node: usize, moment: Moment) -> Result<View, CharacterError> {
        let Some(camera) = camera_of(self.player.document(), node) else {
            return Err(CharacterError::NoCamera { node });
        };
        let Projection::Perspective {
            vertical_angle,
            near,
            far,
            ..
        } = camera.projection
        else {
            return Err(CharacterError::ParallelProjection { node });
        };
        let pose = self.player.pose(moment.animation, moment.seconds)?;
        let frame = pose.world[node];
        let axis = |axis: usize| Vector::from(frame.linear.map(|row| row[axis]));
        let [up, back] = [1, 2].map(|number| axis(number).normalized().unwrap_or_default());
        let eye = frame.translation;
        let target = (Vector::from(eye) - back).coordinates();
        let view = View::look_at(
            eye,
            target,
            up.coordinates(),
            vertical_angle.into(),
            near.into(),
        );
        let view = view.and_then(|view| match far {
            Some(far) => view.with_far(far.into()),
            None => Ok(view),
        });
        view.map_err(|source| CharacterError::View { node, source })
    }

    /// What cannot be drawn as the document asks; a sentence each.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        self.model.warnings()
    }
}

/// The camera of a node.
#[must_use]
pub fn camera_of(document: &Document, node: usize) -> Option<&CameraElement> {
    document.cameras.get(document.nodes.get(node)?.camera?)
}
