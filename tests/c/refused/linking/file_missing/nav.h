/* What nav.c defines, which nobody names. */
extern int heading;

int prints(int angle);
