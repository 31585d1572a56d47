mod facet;
mod lighting;
mod pixel;
mod quadric;
mod transform;
mod zones;
