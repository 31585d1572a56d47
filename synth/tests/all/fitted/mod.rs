mod estimate;
mod modules;
