mod bezier;
mod courses;
mod cover;
mod meetings;
mod polynomial;
