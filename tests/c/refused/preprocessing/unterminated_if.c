/* #if without #endif. */
#ifdef __STDC__ // error: 
int main(void)
{
    return 0;
}
