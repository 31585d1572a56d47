mod bind;
mod mutants;
