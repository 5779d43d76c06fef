/* Names for the linker that are none. */
int f(void) __asm__("two words");  // error: 'asm' needs a name in quotes here
//          ^
int g asm("");  // error: 'asm' needs a name in quotes here
int main(void) { return 0; }
