//! What a mesh has beside positions and faces.

use crate::attribute::{check_finite, unit};
use crate::{
    Group, Material, Mesh, MeshError, Normals, Polylines, Rgba, Tangents, TextureCoordinates,
};

impl Mesh {
    /// The same mesh with a colour for each vertex.
    ///
    /// # Errors
    ///
    /// [`MeshError::ColourCount`] and [`MeshError::AttributeNotFinite`].
    pub fn with_colours(mut self, colours: Vec<Rgba>) -> Result<Self, MeshError> {
        if colours.len() != self.vertex_count() {
            return Err(MeshError::ColourCount {
                vertices: self.vertex_count(),
                colours: colours.len(),
            });
        }
        for (index, colour) in colours.iter().enumerate() {
            check_finite("colour", index, colour)?;
        }
        self.colours = Some(colours);
        Ok(self)
    }

    /// The same mesh with these sets of texture coordinates. Textures of materials refer to a set
    /// by its index here.
    ///
    /// # Errors
    ///
    /// [`MeshError::AttributeNotFinite`], [`MeshError::AttributeLength`] and
    /// [`MeshError::AttributeOutOfRange`].
    pub fn with_texture_coordinates(
        mut self,
        sets: Vec<TextureCoordinates>,
    ) -> Result<Self, MeshError> {
        const NAME: &str = "texture coordinate";
        for set in &sets {
            for (index, value) in set.values.iter().enumerate() {
                check_finite(NAME, index, value)?;
            }
            set.check(NAME, &self.faces)?;
        }
        self.texture_coordinates = sets;
        Ok(self)
    }

    /// The same mesh with these normals, which are normalised unless they have length 1 but for an
    /// error of 10⁻⁶.
    ///
    /// # Errors
    ///
    /// [`MeshError::AttributeNotFinite`], [`MeshError::ZeroVector`],
    /// [`MeshError::AttributeLength`] and [`MeshError::AttributeOutOfRange`].
    pub fn with_normals(mut self, mut normals: Normals) -> Result<Self, MeshError> {
        const NAME: &str = "normal";
        for (index, normal) in normals.values.iter_mut().enumerate() {
            *normal = unit(NAME, index, *normal)?;
        }
        normals.check(NAME, &self.faces)?;
        self.normals = Some(normals);
        Ok(self)
    }

    /// The same mesh with these tangents, normalised as by [`Mesh::with_normals`].
    ///
    /// # Errors
    ///
    /// As [`Mesh::with_normals`], and [`MeshError::Handedness`].
    pub fn with_tangents(mut self, mut tangents: Tangents) -> Result<Self, MeshError> {
        const NAME: &str = "tangent";
        for (index, tangent) in tangents.values.iter_mut().enumerate() {
            tangent.direction = unit(NAME, index, tangent.direction)?;
            let handedness = tangent.handedness;
            if handedness.abs() != 1.0 {
                return Err(MeshError::Handedness { index, handedness });
            }
        }
        tangents.check(NAME, &self.faces)?;
        self.tangents = Some(tangents);
        Ok(self)
    }

    /// The same mesh with these groups; the faces of each are put in rising order, each once.
    ///
    /// # Errors
    ///
    /// [`MeshError::GroupOutOfRange`].
    pub fn with_groups(mut self, groups: Vec<Group>) -> Result<Self, MeshError> {
        self.groups = self.sorted(groups)?;
        Ok(self)
    }

    /// The same mesh with these objects, sets of faces like groups, but each face in one at most:
    /// the first that lists it.
    ///
    /// # Errors
    ///
    /// [`MeshError::GroupOutOfRange`].
    pub fn with_objects(mut self, objects: Vec<Group>) -> Result<Self, MeshError> {
        let mut objects = self.sorted(objects)?;
        if objects.len() > 1 {
            let mut taken = vec![false; self.faces.len()];
            for object in &mut objects {
                let free = |face: &u32| !std::mem::replace(&mut taken[*face as usize], true);
                object.faces.retain(free);
            }
        }
        self.objects = objects;
        Ok(self)
    }

    fn sorted(&self, mut groups: Vec<Group>) -> Result<Vec<Group>, MeshError> {
        let faces = self.faces.len();
        for group in &mut groups {
            group.faces.sort_unstable();
            group.faces.dedup();
            if let Some(&face) = group.faces.last().filter(|&&face| face as usize >= faces) {
                let group = group.name.clone();
                return Err(MeshError::GroupOutOfRange { group, face, faces });
            }
        }
        Ok(groups)
    }

    /// The same mesh with these materials and, for each face, the index of its material.
    ///
    /// # Errors
    ///
    /// [`MeshError::MaterialNumber`], [`MeshError::FaceMaterialCount`] and
    /// [`MeshError::MaterialOutOfRange`].
    pub fn with_materials(
        mut self,
        materials: Vec<Material>,
        of_faces: Vec<Option<u32>>,
    ) -> Result<Self, MeshError> {
        for material in &materials {
            if let Some(number) = material.faulty_number() {
                let material = material.name.clone();
                return Err(MeshError::MaterialNumber { material, number });
            }
        }
        let (faces, found) = (self.faces.len(), of_faces.len());
        if faces != found {
            return Err(MeshError::FaceMaterialCount { faces, found });
        }
        let out_of_range = |material: &u32| *material as usize >= materials.len();
        for (face, material) in of_faces.iter().enumerate() {
            if let Some(material) = material.filter(out_of_range) {
                let materials = materials.len();
                return Err(MeshError::MaterialOutOfRange {
                    face,
                    material,
                    materials,
                });
            }
        }
        self.face_materials = if materials.is_empty() {
            Vec::new()
        } else {
            of_faces
        };
        self.materials = materials;
        Ok(self)
    }

    /// The same mesh with these polylines beside its faces.
    ///
    /// # Errors
    ///
    /// [`MeshError::PolylineOutOfRange`].
    pub fn with_polylines(mut self, polylines: Polylines) -> Result<Self, MeshError> {
        let vertices = self.vertex_count();
        for (polyline, line) in polylines.iter().enumerate() {
            if let Some(&index) = line.iter().find(|&&index| index as usize >= vertices) {
                return Err(MeshError::PolylineOutOfRange {
                    polyline,
                    index,
                    vertices,
                });
            }
        }
        self.polylines = polylines;
        Ok(self)
    }

    /// The same mesh with these vertices drawn as points.
    ///
    /// # Errors
    ///
    /// [`MeshError::PointOutOfRange`].
    pub fn with_points(mut self, points: Vec<u32>) -> Result<Self, MeshError> {
        let vertices = self.vertex_count();
        let out_of_range = |index: &u32| *index as usize >= vertices;
        if let Some(point) = points.iter().position(out_of_range) {
            return Err(MeshError::PointOutOfRange {
                point,
                index: points[point],
                vertices,
            });
        }
        self.points = points;
        Ok(self)
    }

    /// The colours of the vertices, if the mesh has any.
    #[must_use]
    pub fn colours(&self) -> Option<&[Rgba]> {
        self.colours.as_deref()
    }

    /// The first set of texture coordinates, if the mesh has any.
    #[must_use]
    pub fn texture_coordinates(&self) -> Option<&TextureCoordinates> {
        self.texture_coordinates.first()
    }

    /// All sets of texture coordinates.
    #[must_use]
    pub fn texture_coordinate_sets(&self) -> &[TextureCoordinates] {
        &self.texture_coordinates
    }

    /// The normals that the mesh was given, if any; see [`normals`](crate::normals) for those that
    /// follow from its shape.
    #[must_use]
    pub fn normals(&self) -> Option<&Normals> {
        self.normals.as_ref()
    }

    /// The tangents, if the mesh has any.
    #[must_use]
    pub fn tangents(&self) -> Option<&Tangents> {
        self.tangents.as_ref()
    }

    /// The groups, in the order of the file. A face may be in several.
    #[must_use]
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The group of this name.
    #[must_use]
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups.iter().find(|group| group.name == name)
    }

    /// The objects, in the order of the file. A face is in one at most.
    #[must_use]
    pub fn objects(&self) -> &[Group] {
        &self.objects
    }

    /// The object of this name.
    #[must_use]
    pub fn object(&self, name: &str) -> Option<&Group> {
        self.objects.iter().find(|object| object.name == name)
    }

    /// The materials.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// For each face the index of its material; empty where the mesh has no materials.
    #[must_use]
    pub fn face_materials(&self) -> &[Option<u32>] {
        &self.face_materials
    }

    /// The material of a face.
    #[must_use]
    pub fn material(&self, face: usize) -> Option<&Material> {
        let index = (*self.face_materials.get(face)?)?;
        self.materials.get(index as usize)
    }

    /// The polylines beside the faces.
    #[must_use]
    pub fn polylines(&self) -> &Polylines {
        &self.polylines
    }

    /// The vertices that are drawn as points.
    #[must_use]
    pub fn points(&self) -> &[u32] {
        &self.points
    }
}
