/* The directive #error. */
#if __STDC__
#error this program wants another compiler // error: this program wants another compiler
#endif

int main(void)
{
    return 0;
}
