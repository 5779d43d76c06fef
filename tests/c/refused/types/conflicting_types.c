/* Two declarations that do not agree. */
extern int level;
double level; // error: different type

int main(void)
{
    return 0;
}
