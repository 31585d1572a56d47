mod curve;
mod lit_sphere;
mod words;
