mod cut;
mod facts;
mod mutant;
