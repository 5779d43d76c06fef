/* Modes that no type has here. */
typedef int huge __attribute__((mode(TI))); // error: 'int' has no mode 'TI'
typedef float wrong __attribute__((mode(SI))); // error: 'float' has no mode 'SI'
int table[3] __attribute__((mode(HI))); // error: 'int[3]' has no mode 'HI'

int main(void)
{
    return 0;
}
