//! Heights made at random by dividing regions at their middles (thesis of Coquillart, section 4.2, Algs 4-1 to 4-5).
//!
//! A region is four edges, an edge two vertices or, once divided, two edges; neighbours share them, so there are no
//! cracks and nothing is computed twice. Regions are visited south-west, south-east, north-west, north-east, and what
//! no later region needs is freed at once: the storage grows with the side of the grid, not with its area.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use slab::Slab;

/// Most levels: a grid of 1025 x 1025 nodes.
pub const MAX_LEVELS: u32 = 10;

/// What to make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldOptions {
    /// Levels n of recursion, 1 to [`MAX_LEVELS`]: `2^n + 1` nodes a side.
    pub levels: u32,
    /// The h of the source, 0 (each level as rough as the one before) to 1 (smooth): the displacements of a level have
    /// `2^-h` times the deviation of the level before.
    pub smoothness: f64,
    /// Standard deviation of the corners of the grid, and of a displacement at level 0, in units of height.
    pub relief: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// A field of heights.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Nodes of a side.
    pub side: usize,
    /// Heights row by row, the northern row first.
    pub heights: Vec<f64>,
    /// Most vertices that were held at once.
    pub most_vertices: usize,
    /// Most edges that were held at once.
    pub most_edges: usize,
}

/// Makes a field; the same options give the same field. An error says which option is out of its range, and the range.
pub fn field(options: &FieldOptions) -> Result<Field, String> {
    let FieldOptions { levels, relief, .. } = *options;
    let smoothness = options.smoothness;
    if !(1..=MAX_LEVELS).contains(&levels) {
        return Err(format!("{levels} levels; 1 to {MAX_LEVELS} are accepted"));
    }
    if !(0.0..=1.0).contains(&smoothness) {
        let problem = format!("a roughness exponent h of {smoothness}");
        return Err(format!("{problem}; 0 (rough) to 1 (smooth) is accepted"));
    }
    if !(relief > 0.0 && relief <= 1e6) {
        let accepted = "more than 0 and up to 1000000 is accepted";
        return Err(format!("a relief of {relief}; {accepted}"));
    }
    let side = (1 << levels) + 1;
    let mut maker = Maker {
        random: ChaCha8Rng::seed_from_u64(options.seed),
        factor: (-smoothness).exp2(),
        made: Field {
            side,
            heights: vec![0.0; side * side],
            most_vertices: 0,
            most_edges: 0,
        },
        vertices: Slab::new(),
        edges: Slab::new(),
    };
    let far = side - 1;
    let [sw, se, nw, ne] = [[0, 0], [far, 0], [0, far], [far, far]].map(|at| {
        let value = maker.displacement(relief);
        maker.vertex(at, value)
    });
    let area = [[sw, nw], [sw, se], [nw, ne], [se, ne]].map(|ends| maker.edge(ends));
    maker.region(area, relief, levels);
    // The sides to the north and east belong to no later region.
    let mut open = area[2..].to_vec();
    while let Some(edge) = open.pop() {
        open.extend(maker.free(edge).into_iter().flatten());
    }
    Ok(maker.made)
}

#[derive(Clone, Copy)]
struct Vertex {
    /// Node of the grid, eastwards and northwards.
    at: [usize; 2],
    value: f64,
    uses: u32,
}

#[derive(Clone, Copy)]
enum Edge {
    /// With its ends.
    Whole([usize; 2]),
    /// With its halves and the vertex between them.
    Divided([usize; 2], usize),
}

struct Maker {
    random: ChaCha8Rng,
    factor: f64,
    made: Field,
    vertices: Slab<Vertex>,
    edges: Slab<Edge>,
}

impl Maker {
    fn displacement(&mut self, deviation: f64) -> f64 {
        let x: f64 = StandardNormal.sample(&mut self.random);
        deviation * x
    }

    fn vertex(&mut self, at: [usize; 2], value: f64) -> usize {
        let vertex = self.vertices.insert(Vertex { at, value, uses: 0 });
        self.made.most_vertices = self.made.most_vertices.max(self.vertices.len());
        vertex
    }

    fn edge(&mut self, ends: [usize; 2]) -> usize {
        for end in ends {
            self.vertices[end].uses += 1;
        }
        let edge = self.edges.insert(Edge::Whole(ends));
        self.made.most_edges = self.made.most_edges.max(self.edges.len());
        edge
    }

    /// A vertex that nothing uses any more has its final height.
    fn release(&mut self, vertex: usize) {
        self.vertices[vertex].uses -= 1;
        if self.vertices[vertex].uses == 0 {
            let Vertex { at, value, .. } = self.vertices.remove(vertex);
            let side = self.made.side;
            self.made.heights[(side - 1 - at[1]) * side + at[0]] = value;
        }
    }

    /// A vertex in the middle of two others, whose height is their mean and a displacement.
    fn middle(&mut self, ends: [usize; 2], deviation: f64) -> usize {
        let [a, b] = ends.map(|v| self.vertices[v]);
        let at = std::array::from_fn(|k| (a.at[k] + b.at[k]) / 2);
        let value = 0.5 * (a.value + b.value) + self.displacement(deviation);
        self.vertex(at, value)
    }

    /// Divides an edge at a new vertex, unless a neighbour has done so already: its halves and the vertex.
    fn divide(&mut self, edge: usize, deviation: f64) -> ([usize; 2], usize) {
        match self.edges[edge] {
            Edge::Divided(halves, middle) => (halves, middle),
            Edge::Whole(ends) => {
                let middle = self.middle(ends, deviation);
                (self.divide_at(edge, ends, middle), middle)
            }
        }
    }

    fn divide_at(&mut self, edge: usize, [from, to]: [usize; 2], vertex: usize) -> [usize; 2] {
        let halves = [self.edge([from, vertex]), self.edge([vertex, to])];
        self.edges[edge] = Edge::Divided(halves, vertex);
        self.release(from);
        self.release(to);
        halves
    }

    /// New edges between the middles of the sides, upright and flat, with their halves, about the mean of two
    /// estimates.
    fn inner(&mut self, [w, s, n, e]: [usize; 4], deviation: f64) -> [(usize, [usize; 2]); 2] {
        let [centre, twin] = [[s, n], [w, e]].map(|ends| self.middle(ends, deviation));
        let other = self.vertices.remove(twin).value;
        let centre_value = &mut self.vertices[centre].value;
        *centre_value = 0.5 * (*centre_value + other);
        [[s, n], [w, e]].map(|ends| {
            let edge = self.edge(ends);
            (edge, self.divide_at(edge, ends, centre))
        })
    }

    /// Gives back an edge with its ends; the halves of a divided one stay.
    fn free(&mut self, edge: usize) -> Option<[usize; 2]> {
        match self.edges.remove(edge) {
            Edge::Divided(halves, _) => Some(halves),
            Edge::Whole(ends) => {
                ends.into_iter().for_each(|end| self.release(end));
                None
            }
        }
    }

    /// Fills a region with edges W, S, N, E, and gives back its sides to the west and south: no later region has them.
    fn region(&mut self, area: [usize; 4], deviation: f64, levels: u32) {
        if levels > 0 {
            let (next, below) = (deviation * self.factor, levels - 1);
            let sides = area.map(|edge| self.divide(edge, next));
            let [w, s, n, e] = sides.map(|(halves, _)| halves);
            let [(upright, v), (flat, h)] = self.inner(sides.map(|(_, middle)| middle), next);
            self.region([w[0], s[0], h[0], v[0]], next, below);
            self.region([v[0], s[1], h[1], e[0]], next, below);
            self.region([w[1], h[0], n[0], v[1]], next, below);
            self.region([v[1], h[1], n[1], e[1]], next, below);
            self.free(upright);
            self.free(flat);
        }
        self.free(area[0]);
        self.free(area[1]);
    }
}

/// A file of heights: a comment that says how it was made, the distance of nodes, and rows rounded to a thousandth.
pub fn heights_text(field: &Field, options: &FieldOptions, step: f64) -> String {
    let mut text = format!(
        "# imogene terrain --levels {} --roughness {} --relief {} --seed {}\nstep {step} {step}\n",
        options.levels, options.smoothness, options.relief, options.seed
    );
    for row in field.heights.chunks(field.side) {
        // A rounded number prints without the digits of its error; -0 prints as 0.
        let rounded = |height: &f64| ((height * 1000.0).round() / 1000.0 + 0.0).to_string();
        text += &row.iter().map(rounded).collect::<Vec<_>>().join(" ");
        text.push('\n');
    }
    text
}
