mod grid;
mod measure;
mod shapes;
mod truth;
