mod keys;
mod lit_sphere;
mod validation;
