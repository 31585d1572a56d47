mod keys;
mod machine;
mod validation;
