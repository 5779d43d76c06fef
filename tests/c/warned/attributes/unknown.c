/* Unknown attributes. */
int a __attribute__((alligned(4)));  // warning: did you mean 'aligned'?
//                   ^
int b __attribute__((unheard_of)), c __attribute__((unused));  // warning: unknown attribute 'unheard_of' is ignored
int main(void) { return a + b + c; }
