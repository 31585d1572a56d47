mod families;
mod grid;
mod measure;
mod truth;
