char name[] = "scan";
int table[3] = {1};
int speed(int n) { return n; }
int count = 4;
int limit(int n) { return n; }
double shared;  // warning: 'shared' is 'double' here, but 'int' where it is defined
