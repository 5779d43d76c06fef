/* Tentative definitions in a header, as programs of the 1990s have them. */
int steps;
int limit;
char label[10];
void advance(void);
