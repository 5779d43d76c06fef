#include <stdio.h>
int State[45], mode;
void show(void) { printf("%d %d\n", State[44], mode); }
