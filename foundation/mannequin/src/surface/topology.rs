//! Triangles and which of them meet at each vertex, under the three changes that keep a surface a
//! manifold.

/// A triangle mesh that can be changed edge by edge.
#[derive(Clone, Debug)]
pub(crate) struct Topology {
    triangles: Vec<Option<[u32; 3]>>,
    /// The triangles at each vertex.
    around: Vec<Vec<u32>>,
}

impl Topology {
    pub(crate) fn new(vertices: usize, triangles: Vec<[u32; 3]>) -> Self {
        let mut around = vec![Vec::new(); vertices];
        for (i, triangle) in triangles.iter().enumerate() {
            for v in triangle {
                around[*v as usize].push(i as u32);
            }
        }
        Topology {
            triangles: triangles.into_iter().map(Some).collect(),
            around,
        }
    }

    /// The triangles that are left, in a fixed order.
    pub(crate) fn live_triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.triangles.iter().flatten().copied()
    }

    /// The triangles at a vertex.
    pub(crate) fn triangles_around(&self, v: u32) -> impl Iterator<Item = [u32; 3]> + Clone {
        let around = self.around[v as usize].iter();
        around.filter_map(|t| self.triangles[*t as usize])
    }

    /// How many triangles there are at a vertex.
    pub(crate) fn triangle_count(&self, v: u32) -> usize {
        self.around[v as usize].len()
    }

    /// The vertices that share an edge with a vertex, each once.
    pub(crate) fn neighbours(&self, v: u32) -> Vec<u32> {
        let mut neighbours = Vec::with_capacity(8);
        for triangle in self.triangles_around(v) {
            for n in triangle {
                if n != v && !neighbours.contains(&n) {
                    neighbours.push(n);
                }
            }
        }
        neighbours
    }

    /// Every edge once, the lesser vertex first, in rising order of it.
    pub(crate) fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        for v in 0..self.around.len() as u32 {
            let first = edges.len();
            for n in self.triangles_around(v).flatten() {
                if n > v && !edges[first..].contains(&[v, n]) {
                    edges.push([v, n]);
                }
            }
        }
        edges
    }

    pub(crate) fn has_edge(&self, a: u32, b: u32) -> bool {
        self.triangles_at_edge(a, b).next().is_some()
    }

    /// Whether an edge is one that only one triangle has.
    pub(crate) fn is_rim(&self, a: u32, b: u32) -> bool {
        self.triangles_at_edge(a, b).count() == 1
    }

    /// The numbers of the triangles that hold both vertices.
    fn triangles_at_edge(&self, a: u32, b: u32) -> impl Iterator<Item = u32> {
        let holds_b = move |t: &u32| self.triangles[*t as usize].is_some_and(|t| t.contains(&b));
        self.around[a as usize].iter().copied().filter(holds_b)
    }

    /// For each vertex whether it lies on an edge that only one triangle has.
    pub(crate) fn rim(&self) -> Vec<bool> {
        let mut rim = vec![false; self.around.len()];
        for [a, b] in self.edges() {
            if self.is_rim(a, b) {
                rim[a as usize] = true;
                rim[b as usize] = true;
            }
        }
        rim
    }

    /// The third vertices of the two triangles at an edge: of the one that runs from a to b, then
    /// of the other.
    pub(crate) fn opposite(&self, a: u32, b: u32) -> Option<[u32; 2]> {
        let mut opposite = [None; 2];
        for t in self.triangles_at_edge(a, b) {
            let triangle = self.triangles[t as usize]?;
            for k in 0..3 {
                if triangle[k] == a && triangle[(k + 1) % 3] == b {
                    opposite[0] = Some(triangle[(k + 2) % 3]);
                } else if triangle[k] == b && triangle[(k + 1) % 3] == a {
                    opposite[1] = Some(triangle[(k + 2) % 3]);
                }
            }
        }
        Some([opposite[0]?, opposite[1]?])
    }

    /// Puts a new vertex, numbered after all others, on an edge.
    pub(crate) fn split(&mut self, a: u32, b: u32) {
        let new = self.around.len() as u32;
        self.around.push(Vec::new());
        for t in self.triangles_at_edge(a, b).collect::<Vec<_>>() {
            let Some(triangle) = self.triangles[t as usize] else {
                continue;
            };
            let with = |from: u32| triangle.map(|v| if v == from { new } else { v });
            let (first, second) = (with(b), with(a));
            self.remove(t);
            self.insert(t, first);
            self.triangles.push(None);
            self.insert(self.triangles.len() as u32 - 1, second);
        }
    }

    /// Merges the vertex `drop` into its neighbour `keep`.
    pub(crate) fn collapse(&mut self, keep: u32, drop: u32) {
        for t in self.around[drop as usize].clone() {
            let Some(triangle) = self.triangles[t as usize] else {
                continue;
            };
            self.remove(t);
            if !triangle.contains(&keep) {
                self.insert(t, triangle.map(|v| if v == drop { keep } else { v }));
            }
        }
    }

    /// Replaces the edge a–b between the triangles a b c and b a d by c–d.
    pub(crate) fn flip(&mut self, a: u32, b: u32, c: u32, d: u32) {
        let triangles: Vec<u32> = self.triangles_at_edge(a, b).collect();
        for t in &triangles {
            self.remove(*t);
        }
        for (t, triangle) in triangles.iter().zip([[c, a, d], [d, b, c]]) {
            self.insert(*t, triangle);
        }
    }

    fn remove(&mut self, t: u32) {
        if let Some(triangle) = self.triangles[t as usize].take() {
            for v in triangle {
                self.around[v as usize].retain(|other| *other != t);
            }
        }
    }

    fn insert(&mut self, t: u32, triangle: [u32; 3]) {
        self.triangles[t as usize] = Some(triangle);
        for v in triangle {
            self.around[v as usize].push(t);
        }
    }
}
