//! Terrain: a grid of heights as quadric cells.
