int State[45];
int mode = 3;
char *title;
void set(void) { State[0] = 40; title = "set"; }
